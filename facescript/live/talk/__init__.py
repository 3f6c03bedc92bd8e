"""What a program tells a face that is running: say this, look there, be still."""
