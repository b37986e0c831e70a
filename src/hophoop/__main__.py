"""`python -m hophoop` and `hophoop`: the command line."""

import os
import signal


def _stop(number: int, frame: object) -> None:
    """End at once, before anything has begun; a handler of signals."""
    os.write(2, b"Stopped.\n")
    os._exit(128 + number)


_early = signal.getsignal(signal.SIGINT) is signal.default_int_handler
if _early:
    signal.signal(signal.SIGINT, _stop)  # Python's own shows a traceback of imports

from hophoop._support.stopping import stop_on_signals  # noqa: E402

if _early:
    signal.signal(signal.SIGINT, signal.default_int_handler)  # for those who only import this module


def main() -> None:
    """Run the command that the process was started with."""
    with stop_on_signals(alone=True):
        from hophoop.cli import app  # takes a tenth of a second, in which Ctrl-C is heard already

        app()


if __name__ == "__main__":
    main()
