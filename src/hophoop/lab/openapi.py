"""The OpenAPI document of the programming interface."""

from __future__ import annotations

from typing import Any

from hophoop.lab import files
from hophoop.lab.limits import USUAL
from hophoop.scenario import Scenario

PREFIX = "#/components/schemas/"


def _number() -> dict[str, Any]:
    return {"type": "number"}


RESULT = {
    "type": "object",
    "description": "A motion: events with the states just after them, final state, energies; SI, radians.",
    "required": ["schema", "version", "scenario", "status", "sequence", "events", "final", "energy"],
    "properties": {
        "schema": {"const": "hophoop/1"},
        "version": {"type": "string"},
        "scenario": {"type": "object"},
        "status": {"enum": ["completed", "at_rest", "jammed", "undetermined", "event_limit"]},
        "sequence": {
            "type": "string",
            "description": "One letter a phase: R roll, S spin, K skid, H flight, M skim",
        },
        "events": {"type": "array", "items": {"type": "object"}},
        "final": {"type": "object"},
        "energy": {"type": "object", "additionalProperties": _number()},
        "samples": {"type": "object", "description": "Name → values at equally spaced times"},
    },
}

THEORY = {
    "type": "object",
    "required": ["thresholds"],
    "properties": {
        "thresholds": {
            "type": "array",
            "items": {
                "type": "object",
                "required": ["key", "label", "value", "unit", "text"],
                "properties": {
                    "key": {"type": "string"},
                    "label": {"type": "string"},
                    "value": {"type": ["number", "null"]},
                    "unit": {"type": "string"},
                    "text": {"type": "string"},
                },
            },
        }
    },
}

MAP = {
    "type": "object",
    "required": ["x", "y", "what", "values"],
    "properties": {
        "x": {"type": "object"},
        "y": {"type": "object"},
        "what": {"type": "string"},
        "classes": {"type": ["array", "null"], "items": {"type": "object"}},
        "values": {"type": "array", "items": {"type": "array", "items": {"type": ["number", "null"]}}},
    },
}

ERROR = {
    "type": "object",
    "required": ["detail"],
    "properties": {
        "detail": {"type": "string", "description": "One sentence: what is wrong and what is allowed"}
    },
}


def _axis() -> dict[str, Any]:
    return {
        "type": "object",
        "required": ["path", "from", "to"],
        "additionalProperties": False,
        "properties": {
            "path": {"type": "string", "description": "A parameter, such as plane.mu"},
            "from": _number(),
            "to": _number(),
            "cells": {"type": "integer", "minimum": 1, "maximum": 4096, "default": 48},
        },
    }


MAP_REQUEST = {
    "type": "object",
    "required": ["x", "y"],
    "additionalProperties": False,
    "properties": {
        "scenario": {"$ref": PREFIX + "Scenario"},
        "x": {"$ref": PREFIX + "Axis"},
        "y": {"$ref": PREFIX + "Axis"},
        "what": {"type": "string", "default": "class", "description": "The quantity that is mapped"},
    },
}


def document(version: str) -> dict[str, Any]:
    """The OpenAPI document.

    Parameters
    ----------
    version : str
        Of the package.

    Returns
    -------
    document : dict
    """
    scenario = Scenario.model_json_schema(ref_template=PREFIX + "{model}")
    schemas = {**scenario.pop("$defs", {}), "Scenario": scenario}
    schemas |= {"Result": RESULT, "Theory": THEORY, "Map": MAP, "Axis": _axis(), "MapRequest": MAP_REQUEST}
    schemas["Error"] = ERROR
    samples = {
        "name": "samples",
        "in": "query",
        "description": "How many equally spaced states to add; 0 for none",
        "schema": {
            "type": "integer",
            "minimum": 0,
            "maximum": USUAL.samples,
            "default": 0,
            "not": {"const": 1},
        },
    }
    file_name = {
        "name": "name",
        "in": "path",
        "required": True,
        "schema": {"enum": list(files.KINDS)},
        "description": "The file; the query is a scenario's link, such as plane.mu=0.5&start.speed=2.8",
    }
    return {
        "openapi": "3.1.0",
        "info": {
            "title": "hophoop lab",
            "version": version,
            "description": "Exact motion of a loaded hoop on a plane. Equal requests have equal ETags.",
        },
        "paths": {
            "/api/v1/simulate": {
                "post": _post("simulate", "Compute a motion", "Scenario", "Result", [samples])
            },
            "/api/v1/theory": {"post": _post("theory", "Thresholds of theory", "Scenario", "Theory", [])},
            "/api/v1/map": {"post": _post("map", "A map over two parameters", "MapRequest", "Map", [])},
            "/api/v1/files/{name}": {
                "get": {
                    "operationId": "download",
                    "summary": "A file of a motion",
                    "parameters": [file_name],
                    "responses": {
                        "200": {
                            "description": "The file",
                            "content": {kind.media_type: {} for kind in files.KINDS.values()},
                        },
                        **_errors("304", "404", "413", "422", "429", "501"),
                    },
                }
            },
            "/healthz": {
                "get": {
                    "operationId": "health",
                    "summary": "Whether the server answers",
                    "responses": {"200": _content("It does", {"type": "object"})},
                }
            },
        },
        "components": {"schemas": schemas},
    }


def _post(
    name: str, summary: str, takes: str, gives: str, parameters: list[dict[str, Any]]
) -> dict[str, Any]:
    return {
        "operationId": name,
        "summary": summary,
        "parameters": parameters,
        "requestBody": {
            "required": True,
            "content": {"application/json": {"schema": {"$ref": PREFIX + takes}}},
        },
        "responses": {
            "200": {
                **_content("The result", {"$ref": PREFIX + gives}),
                "headers": {
                    "ETag": {"schema": {"type": "string"}, "description": "Equal for equal requests"}
                },
            },
            **_errors("304", "413", "422", "429"),
        },
    }


_MEANINGS = {
    "304": "Not modified: the ETag is known",
    "404": "There is no such file",
    "413": "More than the lab computes at a time",
    "422": "Bad input",
    "429": "Too many requests at once; try again",
    "501": "What makes this file is not installed on the server",
}


def _errors(*codes: str) -> dict[str, Any]:
    return {
        code: {"description": _MEANINGS[code]}
        if code == "304"
        else _content(_MEANINGS[code], {"$ref": PREFIX + "Error"})
        for code in codes
    }


def _content(description: str, schema: dict[str, Any]) -> dict[str, Any]:
    return {"description": description, "content": {"application/json": {"schema": schema}}}
