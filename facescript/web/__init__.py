"""What pages of this machine share: who may ask for them, what passes between them and their server, how they look."""
