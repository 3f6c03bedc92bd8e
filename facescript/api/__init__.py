"""What programs and notebooks use: takes of scripts, and scripts written without text."""
