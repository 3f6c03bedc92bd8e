"""Pictures of a camera to who is there: faces found, told apart, followed, and placed in the room."""
