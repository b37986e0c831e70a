"""`python -m hophoop`: the command line."""

from hophoop.cli import app

app()
