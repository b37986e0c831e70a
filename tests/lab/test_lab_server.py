"""The lab as a server: who may ask, what is sent, and how it ends."""

import gzip
import http.client
import os
import re
import signal
import socket
import subprocess
import sys
import time
from urllib.parse import urlsplit

import pytest

from hophoop.lab import server
from hophoop.lab.wasm.stamp import built
from hophoop.scenario import InputError
from lab_page_tools import serving


@pytest.fixture(scope="module")
def ask():
    """Asks for a path; gives status, headers and body."""
    with serving(names=["hoop.example.org"]) as address:
        line = http.client.HTTPConnection("127.0.0.1", urlsplit(address).port)

        def asked(path="/", host="localhost", method="GET", **headers):
            line.request(method, path, headers={"Host": host, **headers})
            reply = line.getresponse()
            return reply.status, reply.headers, reply.read()

        yield asked


# Who may ask


def test_its_own_names_are_answered_and_foreign_ones_refused(ask):
    for host in ("localhost:8765", "127.0.0.1", "[::1]:8765", "192.168.1.7:80", "hoop.example.org", "a.localhost"):
        assert ask(host=host)[0] == 200, host
    for host in ("evil.example:8765", "127.0.0.1.evil.example", "localhost.evil.example", "", "localhost:b:c"):
        status, headers, body = ask(host=host)
        assert status == 403, host
        assert b"is not a name of this lab" in body
        assert "content-security-policy" in headers


# The page


def test_the_page_names_its_files_and_allows_no_others(ask):
    _, headers, body = ask()
    page = body.decode()
    assert headers["cache-control"] == "no-cache"
    for name in re.findall(r'(?:href|src)="([^"]+)"', page):
        assert ask(f"/{name}")[0] == 200, name
    # the module comes along with the script that asks for it
    (asked,) = re.findall(r'rel="preload" href="static/hophoop\.wasm\?(\w+)"', page)
    assert asked == built()["module"]
    assert not re.search("service-worker|manifest", page)  # of an exported folder
    assert ask("/static/hophoop.wasm")[1]["content-type"] == "application/wasm"
    assert ask("/favicon.ico")[1]["content-type"] == "image/svg+xml"


def test_no_other_file_can_be_reached(ask):
    for path in (
        "/../../server.py",
        "/static/../index.html",
        "/static/%2e%2e%2ftables.py",
        "/static/",
        "/static/tables.json",
        "/film.mp4",
    ):
        assert ask(path)[0] == 404, path
    assert ask(method="POST")[0] == 501


def test_text_is_compressed_for_those_who_take_it(ask):
    _, headers, body = ask("/static/lab.js", **{"Accept-Encoding": "gzip, br"})
    assert headers["content-encoding"] == "gzip"
    assert gzip.decompress(body) == ask("/static/lab.js")[2]


# All of it


def test_slow_clients_keep_no_others_waiting():
    with serving() as address:
        place = "127.0.0.1", urlsplit(address).port
        lines = [socket.create_connection(place, 60) for _ in range(40)]
        for line in lines:
            line.sendall(b"GET / HTTP/1.1\r\nHost: local")
        begin = time.monotonic()
        page = socket.create_connection(place, 60)
        page.sendall(b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n")
        assert b"200 OK" in page.recv(100)
        assert time.monotonic() - begin < 20.0  # those lines last 30 s
        for line in (*lines, page):
            line.close()


@pytest.mark.skipif(os.name != "posix", reason="only POSIX has interrupts of one process")
def test_it_stops_at_once_and_says_nothing_of_those_who_went_away():
    command = [sys.executable, "-m", "hophoop", "lab", "--no-browser", "--port", "0"]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as process:
        port = int(re.search(r"is at http://127.0.0.1:(\d+)/", process.stderr.readline())[1])
        lines = [socket.create_connection(("127.0.0.1", port), 60) for _ in range(6)]
        for line in lines[:4]:
            line.sendall(b"GET /static/lab.js HTTP/1.1\r\nHost: localhost\r\n\r\n")
            line.close()
        time.sleep(0.5)
        begin = time.monotonic()
        process.send_signal(signal.SIGINT)
        said = process.communicate(timeout=60)[1]
        assert time.monotonic() - begin < 20.0  # open connections would keep it for 30 s
        assert said == ""
        assert process.returncode == 0


def test_serve_refuses_bad_addresses():
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        with pytest.raises(InputError, match=r"cannot be used on 127\.0\.0\.1: .*in use"):
            server.serve(port=taken.getsockname()[1])


def test_serve_listens_on_loopback_unless_told_otherwise(monkeypatch, capsys):
    seen = []
    monkeypatch.setattr(server.ThreadingHTTPServer, "serve_forever", lambda one: seen.append(one.server_address))
    monkeypatch.setattr(server, "_own_address", lambda: "192.168.1.7")
    server.serve(port=0)
    ((host, port),) = seen
    assert host == "127.0.0.1"
    assert port > 0
    assert "Others" not in capsys.readouterr().err
    server.serve(host="0.0.0.0", port=0)
    assert re.search(r"Others in your network open http://192\.168\.1\.7:\d+/\.", capsys.readouterr().err)
