"""An act of the timeline that is dragged, to the smallest edit of the script that moves it so."""
