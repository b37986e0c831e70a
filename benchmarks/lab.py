"""How fast the lab is: requests on loopback, memory over many of them, and the time from slider to picture.

    python benchmarks/lab.py [--requests 10000] [--workers 1] [--no-browser]

Starts a server of its own, and prints one JSON object. The browser's part needs playwright and a Chromium.
"""

from __future__ import annotations

import argparse
import asyncio
import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import time
from pathlib import Path
from urllib.request import urlopen

import numpy as np

FLIGHTS = 8  # requests under way at a time


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


def start(workers: int) -> tuple[subprocess.Popen[bytes], str]:
    port = free_port()
    command = [
        sys.executable,
        "-c",
        "from hophoop.cli import app; app()",
        "lab",
        "--port",
        str(port),
        "--workers",
        str(workers),
        "--no-browser",
    ]
    server = subprocess.Popen(command, start_new_session=True)
    address = f"http://127.0.0.1:{port}/"
    for _ in range(1800):
        try:
            with urlopen(address + "healthz", timeout=1):
                return server, address
        except OSError:
            time.sleep(0.1)
    raise SystemExit("the server does not answer")


def family(root: int) -> list[Path]:
    """Folders in /proc of a process and of all that it has started, also in sessions of their own; none without /proc."""
    parents: dict[int, int] = {}
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            parents[int(folder.name)] = int((folder / "stat").read_text().rpartition(")")[2].split()[1])
        except (OSError, ValueError):
            continue
    found = {root} & parents.keys()
    while more := {child for child, parent in parents.items() if parent in found} - found:
        found |= more
    return [Path("/proc") / str(one) for one in found]


def resident(root: int) -> float:
    """Memory of the server's processes in MB; nan where /proc does not tell."""
    total = 0
    for folder in family(root):
        try:
            pages = int((folder / "statm").read_text().split()[1])
            total += pages * os.sysconf("SC_PAGE_SIZE")
        except (OSError, ValueError):
            continue
    return total / 1e6 if total else float("nan")


def processor_seconds(root: int) -> float:
    """Processor time of the server's processes so far [s]; it too grows where other work shares cores and caches."""
    total = 0
    for folder in family(root):
        try:
            fields = (folder / "stat").read_text().rpartition(")")[2].split()
            total += int(fields[11]) + int(fields[12])
        except (OSError, ValueError):
            continue
    return total / os.sysconf("SC_CLK_TCK") if total else float("nan")


async def load(address: str, path: str, bodies: list[bytes], group: int) -> dict[str, float]:
    host, port = address.removeprefix("http://").rstrip("/").split(":")
    times: list[float] = []
    failures = 0
    waiting = iter(bodies)
    memory: list[float] = []

    async def visitor() -> None:
        nonlocal failures
        reader, writer = await asyncio.open_connection(host, int(port))
        for body in waiting:
            begun = time.perf_counter()
            writer.write(
                f"POST {path} HTTP/1.1\r\nHost: {host}\r\nContent-Type: application/json\r\n"
                f"Content-Length: {len(body)}\r\n\r\n".encode()
                + body
            )
            head = (await reader.readuntil(b"\r\n\r\n")).lower()
            length = int(head.partition(b"content-length:")[2].split()[0])
            await reader.readexactly(length)
            times.append(time.perf_counter() - begun)
            failures += b" 200 " not in head.partition(b"\r\n")[0]
            if len(times) % max(len(bodies) // 20, 1) == 0:
                memory.append(resident(group))
        writer.close()

    busy = processor_seconds(group)
    begun = time.perf_counter()
    await asyncio.gather(*(visitor() for _ in range(FLIGHTS)))
    took = time.perf_counter() - begun
    return {
        "requests": len(times),
        "failures": failures,
        "requests_per_second": round(len(times) / took, 1),
        "processor_ms_per_request": round(1e3 * (processor_seconds(group) - busy) / len(times), 2),
        "median_ms": round(1e3 * float(np.median(times)), 2),
        "p99_ms": round(1e3 * float(np.quantile(times, 0.99)), 2),
        # the first tenth fills caches; after it memory must stay
        "memory_after_a_tenth_mb": round(memory[1], 1),
        "memory_at_the_end_mb": round(memory[-1], 1),
    }


def browser_times(address: str) -> dict[str, float] | None:
    try:
        from playwright.sync_api import sync_playwright
    except ImportError:
        return None
    chromium = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if chromium is None:
        return None
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=chromium, args=["--no-sandbox", "--enable-unsafe-swiftshader"])
        page = browser.new_page(viewport={"width": 1440, "height": 900})
        page.goto(address)
        page.wait_for_selector("[data-ready]")
        page.wait_for_timeout(2000)
        page.evaluate("hophoopLab.latencies.length = 0")
        page.evaluate(
            """async () => {
              const slider = document.querySelector("input[data-path='start.speed']");
              for (let k = 0; k < 120; k++) {
                slider.value = String(2 + 0.01 * k);
                slider.dispatchEvent(new Event("input", { bubbles: true }));
                await new Promise((resolve) => setTimeout(resolve, 80));
              }
            }"""
        )
        latencies = page.evaluate("hophoopLab.latencies")
        rate = page.evaluate(
            """async () => {
              hophoopLab.clock.play(true);
              await new Promise((resolve) => setTimeout(resolve, 500));
              const before = hophoopLab.frames;
              await new Promise((resolve) => setTimeout(resolve, 4000));
              return (hophoopLab.frames - before) / 4;
            }"""
        )
        browser.close()
    return {
        "moves": len(latencies),
        "slider_to_picture_median_ms": round(float(np.median(latencies)), 1),
        "slider_to_picture_p90_ms": round(float(np.quantile(latencies, 0.9)), 1),
        "frames_per_second": round(rate, 1),
    }


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--requests", type=int, default=10_000)
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--no-browser", action="store_true")
    options = parser.parse_args()
    server, address = start(options.workers)
    try:
        # each another scenario, so that nothing can be answered from memory
        bodies = [
            json.dumps({"start": {"speed": 1.0 + 3.0 * k / options.requests}, "duration": 6.0}).encode()
            for k in range(options.requests)
        ]
        films = [json.dumps({"scenario": json.loads(body)}).encode() for body in bodies[:: max(options.requests // 1000, 1)]]
        result = {
            "cores": os.cpu_count(),
            "load_average_before": round(os.getloadavg()[0], 2),
            "simulate": asyncio.run(load(address, "/api/v1/simulate", bodies, server.pid)),
            "motion": asyncio.run(load(address, "/lab/motion", films, server.pid)),
        }
        if not options.no_browser:
            result["browser"] = browser_times(address)
        result["load_average_after"] = round(os.getloadavg()[0], 2)
        print(json.dumps(result, indent=1))
    finally:
        os.killpg(server.pid, signal.SIGTERM)
        server.wait(10)


if __name__ == "__main__":
    main()
