"""Files with the layout of Tracker's own saver and exporter (XML control elements, text of point masses), written from what its
source says about names and order; shares no code with the reader."""

import zipfile

import numpy as np

OSP, TRACKER = "org.opensourcephysics", "org.opensourcephysics.cabrillo.tracker"


class Xml:
    """Lines as Tracker's XML control writes them: four spaces a level, an object on a line of its own."""

    def __init__(self):
        self.lines, self.level = ['<?xml version="1.0" encoding="UTF-8"?>'], 0

    def line(self, text):
        self.lines.append("    " * self.level + text)

    def open(self, text):
        self.line(text)
        self.level += 1

    def close(self, word):
        self.level -= 1
        self.line(f"</{word}>")

    def value(self, name, value):
        kinds = {bool: "boolean", int: "int", float: "double", str: "string"}
        text = str(value).lower() if isinstance(value, bool) else repr(value) if isinstance(value, float) else str(value)
        if isinstance(value, str) and any(sign in value for sign in "<>&"):
            text = f"<![CDATA[{value}]]>"
        self.line(f'<property name="{name}" type="{kinds[type(value)]}">{text}</property>')

    def object(self, name, cls, values, version=""):
        """A property with an object of values, which may be functions that write more."""
        self.open(f'<property name="{name}" type="object">')
        self.bare(cls, values, version)
        self.close("property")

    def bare(self, cls, values, version=""):
        self.open(f'<object class="{cls}"{version}>')
        for key, value in values.items():
            if callable(value):
                value(key)
            else:
                self.value(key, value)
        self.close("object")

    def frames(self, cls, rows, length):
        """An array that leaves its nulls out, but for the last element."""

        def write(name):
            self.open(f'<property name="{name}" type="array" class="[L{cls}$FrameData;">')
            for n, row in rows.items():
                self.object(f"[{n}]", f"{cls}$FrameData", row)
            if length - 1 not in rows:
                self.line(f'<property name="[{length - 1}]" type="object">null</property>')
            self.close("property")

        return write


def trk(points, axes, delta_ms, start_frame=0, start_ms=0.0, frames=None, unit="m"):
    """The text of a .trk file.

    `points` are dicts of pixels by frame, by name; `axes` those of the coordinate system by key frame: xorigin, yorigin,
    angle in degrees, xscale, yscale.
    """
    xml = Xml()
    length = frames or max(n for rows in points.values() for n in rows) + 1

    def colour(name):
        xml.object(name, "java.awt.Color", {"red": 13, "green": 235, "blue": 13, "alpha": 255})

    def track(cls, values):
        xml.object("item", f"{TRACKER}.{cls}", values)

    def key_frames(rows):
        def write(name):
            xml.open(f'<property name="{name}" type="array" class="[I">')
            xml.value("array", "{" + ",".join(map(str, rows)) + "}")
            xml.close("property")

        return write

    def tracks(name):
        xml.open(f'<property name="{name}" type="collection" class="java.util.ArrayList">')
        shown = {"color": colour, "visible": True, "trail": False}
        track("CoordAxes", {"name": "axes", **shown})
        ends = {0: {"x1": 10.0, "y1": 20.0, "x2": 10.0, "y2": 120.0, "worldlength": 0.5}}
        track(
            "TapeMeasure",
            {"name": "tape A", **shown, "fixedtape": True, "framedata": xml.frames(f"{TRACKER}.TapeMeasure", ends, 1)},
        )
        for mass, rows in points.items():
            marked = {n: {"x": float(x), "y": float(y)} for n, (x, y) in rows.items()}
            data = xml.frames(f"{TRACKER}.PointMass", marked, length)
            described = {"description": "Hub < 3 & done"} if mass == next(iter(points)) else {}
            track(
                "PointMass", {"mass": 1.0, "name": mass, **described, **shown, "framedata": data, "keyFrames": key_frames(rows)}
            )
        track("PointMass", {"mass": 1.0, "name": "never marked", **shown, "keyFrames": key_frames(())})
        xml.close("property")

    clip = {
        "video": lambda name: xml.object(name, f"{OSP}.media.xuggle.XuggleVideo", {"path": "videos/hoop & co.mp4"}),
        "video_framecount": length, "startframe": start_frame, "stepsize": 1, "stepcount": length - start_frame,
        "starttime": start_ms, "readout": "Step", "playallsteps": True,
    }  # fmt: skip
    control = {"rate": 1.0, "delta_t": delta_ms, "frame": start_frame}
    system = {
        "fixedorigin": len(axes) == 1, "fixedangle": len(axes) == 1, "fixedscale": len(axes) == 1, "locked": False,
        "framedata": xml.frames(f"{OSP}.media.core.ImageCoordSystem", axes, max(axes) + 1),
    }  # fmt: skip
    whole = {
        "semantic_version": "6.1.3", "width": 1280.0, "height": 720.0, "magnification": -1.0,
        "videoclip": lambda name: xml.object(name, f"{OSP}.media.core.VideoClip", clip),
        "clipcontrol": lambda name: xml.object(name, f"{OSP}.media.core.StepperClipControl", control),
        "coords": lambda name: xml.object(name, f"{OSP}.media.core.ImageCoordSystem", system),
        "length_unit": unit, "mass_unit": "kg", "units_visible": True, "tracks": tracks,
        "selectedtrack": next(iter(points)), "selected_track_views": "{0,1,2,3}", "author": "A. N. Other",
    }  # fmt: skip
    xml.bare(f"{TRACKER}.TrackerPanel", whole, ' version="6.1.3"')
    return "\n".join(xml.lines) + "\n"


def trz(path, name, text):
    """An archive as Tracker zips it: the project, its video, a page about it and a picture."""
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr(f"html/{name}_info.html", "<html><title>hoop</title></html>")
        archive.writestr(f"videos/{name}.mp4", b"\x00\x01")
        archive.writestr(f"{name}.trk", text)
        archive.writestr(f"{name}_thumbnail.png", b"\x89PNG")
    return path


def java(value):
    """A number with Java's pattern 0.000000E0."""
    mantissa, exponent = f"{value:.6E}".split("E")
    return f"{mantissa}E{int(exponent)}"


def text_export(t, points, columns, delimiter="\t", comma=False):
    """Tracker's text of point masses: one under another in time, one beside the other by name, a delimiter behind each cell.

    `points` are arrays of columns by name, nan where a cell stays empty.
    """
    lines = ["#multi:"] if len(points) > 1 else []
    lines.append(delimiter + "".join(name + delimiter * len(columns) for name in points))
    lines.append("t" + delimiter + "".join(column + delimiter for _ in points for column in columns))
    for k, moment in enumerate(t):
        cells = [java(moment)]
        for values in points.values():
            cells += ["" if np.isnan(one[k]) else java(one[k]) for one in values]
        lines.append("".join(cell.replace(".", "," if comma else ".") + delimiter for cell in cells))
    return "\n".join(lines) + "\n"
