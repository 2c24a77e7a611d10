"""Serves the explorer on this machine's own loopback address until it is interrupted."""

import contextlib
import socket
import threading
import webbrowser
from collections.abc import Callable

import uvicorn

from hugoniot.errors import FileTrouble
from hugoniot.explorer import catalogue
from hugoniot.explorer.app import application
from hugoniot.explorer.guard import new_token
from hugoniot.explorer.jobs import Jobs
from hugoniot.explorer.places import Places
from hugoniot.explorer.transcribed import theory
from hugoniot.signals import end_like_interrupt

HOST = "127.0.0.1"


def bound(port: int) -> socket.socket:
    """A socket on the loopback address that accepts connections; port 0 for any free one. `FileTrouble` where the port is taken.

    The protocol is named because asyncio sets TCP_NODELAY only on sockets that name it: without it the second part of an answer
    waits for an acknowledgement that the browser delays by 40 ms.
    """
    listener = socket.socket(socket.AF_INET, socket.SOCK_STREAM, socket.IPPROTO_TCP)
    listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listener.bind((HOST, port))
        listener.listen()
    except OSError as error:
        listener.close()
        raise FileTrouble(f"port {port} of {HOST}: {error.strerror or error}; choose another, or 0 for any free one") from None
    return listener


def serve(places: Places, port: int = 0, *, browser: bool = True, view: str = "",
          announce: Callable[[str], None] = lambda text: None) -> None:
    """Serve until interrupted; `announce` is given the address with its token, `view` the part of it that says what to show."""
    listener, token = bound(port), new_token()
    number = listener.getsockname()[1]
    address = f"http://{HOST}:{number}/{token}/{view}"
    with contextlib.closing(Jobs(places)) as jobs, listener:
        app = application(places, jobs, token, (f"{HOST}:{number}", f"localhost:{number}"))
        config = uvicorn.Config(app, log_level="critical", access_log=False, lifespan="off", server_header=False, date_header=False,
                                ws="none", timeout_keep_alive=15, timeout_graceful_shutdown=2)
        threading.Thread(target=lambda: (theory(), catalogue.listing()), daemon=True).start()    # ready when the page asks
        announce(address)
        if browser:
            threading.Timer(0.3, webbrowser.open, (address,)).start()
        with end_like_interrupt(), contextlib.suppress(KeyboardInterrupt):      # which is how it ends; runs keep a checkpoint
            uvicorn.Server(config).run(sockets=[listener])
