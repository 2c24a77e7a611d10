"""Who may ask the explorer, and what it never gives away."""

import asyncio
import itertools
import random
import socket
from concurrent.futures import ThreadPoolExecutor

import pytest
from explorer_words import HOST, TOKEN

from hugoniot.explorer import guard
from hugoniot.page import files


def get(client, path, **headers):
    return client.get(f"/{TOKEN}/{path}", headers=headers)


def test_the_page_and_its_files_come_with_their_policy(client):
    for path in ("", *files.files()):
        answer = get(client, path)
        assert answer.status_code == 200 and answer.headers["content-security-policy"] == guard.POLICY
        assert answer.headers["x-content-type-options"] == "nosniff" and answer.headers["referrer-policy"] == "no-referrer"
    assert "unsafe" not in guard.POLICY and "http" not in guard.POLICY


def test_the_page_asks_nothing_of_other_hosts():
    for name, data in {**files.files(), "index.html": files.index()}.items():
        text = data.decode()
        for scheme in ("http://", "https://", "//cdn"):
            assert all(w in ("http://www.w3.org/2000/svg",) for w in (text[i:i + 26] for i in range(len(text)) if text.startswith(scheme, i))), name
        assert "innerHTML" not in text and "eval(" not in text and "document.write" not in text and "insertAdjacentHTML" not in text, name


@pytest.mark.parametrize("headers", [{"host": "evil.example"}, {"host": "127.0.0.1:1"}, {"host": ""}, {"origin": "http://evil.example"}, {"origin": "null"},
                                     {"origin": "http://127.0.0.1:1"}, {"sec-fetch-site": "cross-site"}, {"sec-fetch-site": "same-site"}])
def test_other_hosts_and_origins_are_not_answered(client, headers):
    assert get(client, "api/start", **headers).status_code == 404
    assert get(client, "api/start", origin=f"http://{HOST}").status_code == 200


def test_without_the_token_there_is_nothing(client):
    for path in ("/", "/api/start", "/index.html", f"/{TOKEN}", f"/{TOKEN[:-1]}/", f"/{TOKEN}x/api/start", f"//{TOKEN[:-1]}b/", "/%61" + TOKEN[2:] + "/"):
        answer = client.get(path)
        assert answer.status_code == 404 and answer.text == "not found"
    assert guard.new_token() != guard.new_token() and len(guard.new_token()) >= 32


def ended(work):
    """A coroutine run to its end in a thread: the driver of a browser, where tests of the page ran before, keeps the loop of this one."""
    with ThreadPoolExecutor(1) as pool:
        return pool.submit(asyncio.run, work).result()


def test_ten_thousand_attempts_to_leave_the_folders_find_nothing(places):
    """Through the application itself, so that no client tidies the path first."""
    from hugoniot.explorer.app import application
    from hugoniot.explorer.jobs import Jobs

    app, draw = application(places, Jobs(places), TOKEN, (HOST,)), random.Random(7)
    ups = ["..", "%2e%2e", "..%2f", "..\\", "....//", "%252e%252e", ".", "//", "..;", "%c0%ae%c0%ae", "\0", "~", "C:"]
    ends = ["etc/passwd", "deck.toml", "result.h5", "app.py", "static/index.html", "proc/self/environ", "cases.csv", "summary.json", "run.log", "__init__.py"]
    starts = ["", "api/", "api/run/", "data/", "static/", "style.css/", "api/array/", "api/job/", "file:///"]
    tried = set()
    while len(tried) < 10_000:
        path = draw.choice(starts) + "/".join(draw.choice(ups) for _ in range(draw.randint(1, 7))) + "/" + draw.choice(ends)
        tried.add(path)

    async def status(path):
        said = []

        async def send(message):
            said.append(message)

        async def receive():
            return {"type": "http.request", "body": b"", "more_body": False}

        scope = {"type": "http", "method": "GET", "path": f"/{TOKEN}/{path}", "raw_path": b"", "query_string": b"", "headers": [(b"host", HOST.encode())],
                 "scheme": "http", "server": ("127.0.0.1", 8123), "client": ("127.0.0.1", 1), "http_version": "1.1", "root_path": ""}
        await app(scope, receive, send)
        return said[0]["status"], b"".join(m.get("body", b"") for m in said[1:])

    async def every():
        return [await status(path) for path in sorted(tried)]

    assert set(ended(every())) == {(404, b"not found")}


def test_numbers_name_what_is_open_and_nothing_else(client):
    for question, key in itertools.product(("run", "array", "sweep", "deck"), ("1", "99", "-1", "../0", "0x0", "1e9", "٣", "0/../../x", "999999999999")):
        answer = get(client, f"api/{question}?{question if question != 'array' else 'run'}={key}&group=snapshots&name=pressure")
        assert list(answer.json()) == ["error"], (question, key)
    assert list(get(client, "api/array?run=0&group=snapshots&name=../../pressure").json()) == ["error"]
    assert list(get(client, "api/array?run=0&group=setup&name=deck").json()) == ["error"]


def test_bodies_and_addresses_are_limited(client):
    post = f"/{TOKEN}/api/check"
    assert client.post(post, content=b"x" * (guard.LARGEST_BODY + 1)).status_code == 413
    assert client.post(post, content=(b"x" * 100_000 for _ in range(25)), headers={"transfer-encoding": "chunked"}).status_code == 413
    assert client.post(post, content=b"", headers={"content-length": "-1"}).status_code == 413
    assert get(client, "api/material?name=" + "x" * 5000).status_code == 404
    assert client.put(f"/{TOKEN}/api/start").status_code == 405 and client.delete(f"/{TOKEN}/").status_code == 405


def test_names_of_decks_and_files_are_data(client):
    """What a deck calls its parts arrives as text in JSON, without a character that could end a script."""
    for question in ("start", "run?run=0", "sweep?sweep=0", "deck?deck=0"):
        answer = get(client, f"api/{question}")
        assert answer.status_code == 200 and "<" not in answer.text and answer.headers["content-type"] == "application/json"
    assert get(client, "api/run?run=0").json()["title"].startswith("<img src=x")
    assert get(client, "api/sweep?sweep=0").json()["columns"][3]["name"] == "<b>note</b>"


@pytest.mark.parametrize("name", ["/etc/passwd", "../secret.csv", "a/b.csv", "C:\\x.csv", "\\\\host\\share", "~/x.csv"])
def test_a_deck_from_the_page_names_no_file_elsewhere(client, name):
    deck = f'[[region]]\nname = "a"\nmaterial = "m"\nfrom = 0\nto = 1\nzones = 2\n[material.m.eos]\nlaw = "table"\nfile = {name!r}\n'
    found = client.post(f"/{TOKEN}/api/check", content=deck).json()
    assert not found["ok"] and "without a path" in found["problems"][0]["text"] and "root:" not in str(found)


def test_a_case_opens_no_folder_outside_the_table(client):
    for row in (0, 2, 7):
        answer = client.post(f"/{TOKEN}/api/case?sweep=0&row={row}")
        assert "has no run folder beside the table" in answer.json()["error"][0]


def test_the_socket_is_of_this_machine_alone_and_sends_at_once():
    """Without TCP_NODELAY the body of an answer waits 40 ms for the browser to acknowledge its head."""
    from hugoniot.explorer.serve import bound

    options = []

    class Server(asyncio.Protocol):
        def connection_made(self, transport):
            options.append(transport.get_extra_info("socket").getsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY))
            transport.close()

    async def connect(listener):
        server = await asyncio.get_running_loop().create_server(Server, sock=listener)
        reader, writer = await asyncio.open_connection(*listener.getsockname())
        await reader.read()
        writer.close()
        server.close()

    listener = bound(0)
    assert listener.getsockname()[0] == "127.0.0.1"
    ended(connect(listener))
    assert options and options[0]
