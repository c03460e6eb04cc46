"""Rerun's viewer in a browser on this machine."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from types import FrameType
from urllib.parse import quote


def serve(recording: Path, port: int) -> None:
    """Rerun's own server, until it is interrupted. Raises OSError where it cannot serve."""
    command = [sys.executable, "-m", "rerun", str(recording), "--serve-web", "--bind", "127.0.0.1",
               "--web-viewer-port", str(port), "--port", str(port + 1), "--hide-welcome-screen"]
    data = quote(f"rerun+http://127.0.0.1:{port + 1}/proxy", safe="")
    print(f"http://127.0.0.1:{port}?url={data} until Ctrl-C", flush=True)
    try:
        code = exit_code(command)
    except KeyboardInterrupt:
        return
    if code != 0:
        raise OSError(f"rerun cannot serve {recording} on port {port}")


def exit_code(command: Sequence[str]) -> int:
    """Of a program that ends when this one does, with all that it has started itself."""
    with ending_by_exception(signal.SIGTERM, signal.SIGHUP):
        program = subprocess.Popen(command, start_new_session=True)
        try:
            return program.wait()
        finally:
            with suppress(ProcessLookupError):
                os.killpg(program.pid, signal.SIGTERM)
            program.wait()


@contextmanager
def ending_by_exception(*signals: signal.Signals) -> Iterator[None]:
    """These signals end this program as sys.exit() does, so that what is to be done is done."""

    def leave(number: int, _: FrameType | None) -> None:
        sys.exit(128 + number)

    before = [signal.signal(each, leave) for each in signals]
    try:
        yield
    finally:
        for each, handler in zip(signals, before, strict=True):
            signal.signal(each, handler)
