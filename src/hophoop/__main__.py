"""`python -m hophoop` and `hophoop`: the command line."""

from hophoop._support.stopping import stop_on_signals


def main() -> None:
    """Run the command that the process was started with."""
    with stop_on_signals(alone=True):
        from hophoop.cli import app  # takes a tenth of a second, in which Ctrl-C is heard already

        app()


if __name__ == "__main__":
    main()
