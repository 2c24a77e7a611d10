"""Who may ask, and how much: only this machine, only with the token of this start, only small bodies, and nothing that a page may run.

The token is the first part of every path, so a page of another origin can neither guess an address nor send a cookie along.
Whatever is wrong with a request, the answer is the same short "not found": it says nothing about what is there.
"""

import secrets
from collections.abc import Awaitable, Callable
from typing import Any

from starlette.responses import PlainTextResponse

LARGEST_BODY = 2_000_000      # bytes: a long deck
LONGEST_QUERY = 4_000
METHODS = ("GET", "HEAD", "POST")
POLICY = ("default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; connect-src 'self'; "
          "base-uri 'none'; form-action 'none'; frame-ancestors 'none'")
HEADERS = {"content-security-policy": POLICY, "x-content-type-options": "nosniff", "referrer-policy": "no-referrer",
           "x-frame-options": "DENY", "cross-origin-opener-policy": "same-origin", "cross-origin-resource-policy": "same-origin",
           "cache-control": "no-store"}
App = Callable[[dict, Callable, Callable], Awaitable[None]]


def new_token() -> str:
    """A token nobody guesses: 192 random bits."""
    return secrets.token_urlsafe(24)


class Guard:
    """Lets a request through to `app`, without the token in its path, if everything about it is as the page itself asks.

    hosts   accepted values of the header Host, such as "127.0.0.1:8765"
    """

    def __init__(self, app: App, token: str, hosts: tuple[str, ...]):
        self.app, self.token, self.hosts = app, token.encode(), hosts

    async def __call__(self, scope, receive, send) -> None:
        if scope["type"] == "lifespan":
            await self.app(scope, receive, send)
            return
        if scope["type"] != "http":
            return
        status = self._refused(scope)
        if status:
            words = {405: "method not allowed", 413: "too large"}.get(status, "not found")
            await PlainTextResponse(words, status, headers=HEADERS)(scope, receive, send)
            return
        rest = scope["path"].partition("/")[2].partition("/")[2]
        inner = {**scope, "path": "/" + rest, "raw_path": ("/" + rest).encode(), "root_path": ""}
        await self.app(inner, _Limited(receive), _with_headers(send))

    def _refused(self, scope) -> int:
        """The status with which a request is refused, 0 for one that passes."""
        headers = {name.decode("latin-1").lower(): value.decode("latin-1") for name, value in scope["headers"]}
        first, slash, _ = scope["path"].lstrip("/").partition("/") if scope["path"].startswith("/") else ("", "", "")
        if not (slash and secrets.compare_digest(first.encode(), self.token) and headers.get("host") in self.hosts):
            return 404
        origin, site = headers.get("origin"), headers.get("sec-fetch-site", "none")
        if origin is not None and origin not in {f"http://{host}" for host in self.hosts} or site not in ("none", "same-origin"):
            return 404
        if len(scope.get("query_string", b"")) > LONGEST_QUERY:
            return 404
        if scope["method"] not in METHODS:
            return 405
        length = headers.get("content-length", "0")
        return 0 if length.isdigit() and int(length) <= LARGEST_BODY else 413


class TooLarge(Exception):
    """A body of more than `LARGEST_BODY` bytes."""


class _Limited:
    """`receive` that stops at the largest body, whatever the headers promised."""

    def __init__(self, receive: Callable):
        self.receive, self.count = receive, 0

    async def __call__(self) -> Any:
        message = await self.receive()
        self.count += len(message.get("body", b""))
        if self.count > LARGEST_BODY:
            raise TooLarge
        return message


def _with_headers(send: Callable) -> Callable:
    """`send` that adds the safety headers to every answer."""
    more = [(name.encode(), value.encode()) for name, value in HEADERS.items()]

    async def sending(message) -> None:
        if message["type"] == "http.response.start":
            message = {**message, "headers": [*message.get("headers", ()), *more]}
        await send(message)

    return sending
