"""The program groundgrid-py."""
