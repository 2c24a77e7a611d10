"""The application: the page, its questions, and the few requests that start or stop a run."""

from typing import Any

import numpy as np
from starlette.applications import Starlette
from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import JSONResponse, PlainTextResponse, Response
from starlette.routing import Route

from hugoniot.errors import HugoniotError
from hugoniot.explorer.answers import QUESTIONS, integer
from hugoniot.explorer.decks import check
from hugoniot.explorer.guard import Guard, TooLarge
from hugoniot.explorer.jobs import Jobs
from hugoniot.explorer.places import Places, as_command
from hugoniot.explorer.tables import run_of_case
from hugoniot.explorer.transcribed import theory
from hugoniot.page import files
from hugoniot.page.reply import encoded

JSON = "application/json"


def application(places: Places, jobs: Jobs, token: str, hosts: tuple[str, ...]) -> Guard:
    """The guarded application for these places."""
    routes = [Route("/", _index),
              *(Route(f"/{name}", _file(name)) for name in (*files.files(), files.THEORY)),
              *(Route(f"/api/{name}", _question(places, answer)) for name, answer in QUESTIONS.items()),
              Route("/api/check", _checked(places), methods=["POST"]),
              Route("/api/job", _started(jobs), methods=["POST"]),
              Route("/api/job/{number:int}", _watched(jobs), methods=["GET"]),
              Route("/api/job/{number:int}/stop", _stopped(jobs), methods=["POST"]),
              Route("/api/case", _case(places), methods=["POST"])]
    app = Starlette(routes=routes, exception_handlers={
        HugoniotError: _refusal, TooLarge: lambda request, error: PlainTextResponse("too large", 413),
        HTTPException: lambda request, error: PlainTextResponse("not found", error.status_code), Exception: _defect})
    app.router.redirect_slashes = False
    return Guard(app, token, hosts)


async def _index(request: Request) -> Response:
    return Response(files.index(), media_type=files.KINDS["html"])


def _file(name: str):
    def send(request: Request) -> Response:
        return Response(theory() if name == files.THEORY else files.files()[name], media_type=files.KINDS[name.rpartition(".")[2]])
    return send


def _question(places: Places, answer):
    def send(request: Request) -> Response:
        return reply(answer(places, request.query_params))
    return send


def reply(value: Any) -> Response:
    """Doubles as they are, with their shape in a header; anything else as JSON."""
    if isinstance(value, np.ndarray):
        shape = ",".join(map(str, value.shape))
        return Response(np.ascontiguousarray(value, "<f8").tobytes(), media_type="application/octet-stream", headers={"x-shape": shape})
    return Response(encoded(value), media_type=JSON)


def _refusal(request: Request, error: Exception) -> Response:
    # with status 200: browsers write every other one to their console, where only defects should stand
    return JSONResponse({"error": as_command(error)})


def _defect(request: Request, error: Exception) -> Response:
    return JSONResponse({"error": [f"unexpected {type(error).__name__}: a bug in hugoniot; please report it"]}, 500)


def _checked(places: Places):
    async def send(request: Request) -> Response:
        from starlette.concurrency import run_in_threadpool

        body = await request.body()
        return reply(await run_in_threadpool(check, body.decode("utf-8", "replace"), places.work))
    return send


def _started(jobs: Jobs):
    async def send(request: Request) -> Response:
        from starlette.concurrency import run_in_threadpool

        body = await request.body()
        return reply(await run_in_threadpool(jobs.start, body.decode("utf-8", "replace")))
    return send


def _watched(jobs: Jobs):
    def send(request: Request) -> Response:
        return reply(jobs.job(request.path_params["number"]).shown())
    return send


def _stopped(jobs: Jobs):
    def send(request: Request) -> Response:
        job = jobs.job(request.path_params["number"])
        job.stop()
        return reply(job.shown())
    return send


def _case(places: Places):
    def send(request: Request) -> Response:
        query = request.query_params
        place, row = places.sweep(integer(query, "sweep")), integer(query, "row")
        return reply({"run": places.add_run(run_of_case(place.path, row), f"{place.name}, case {row + 1}")})
    return send
