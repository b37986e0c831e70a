"""Sphinx configuration; CI builds with warnings as errors."""

import sys
from pathlib import Path

from pybtex.plugin import register_plugin
from pybtex.style.formatting.plain import Style
from pybtex.style.labels import BaseLabelStyle
from sphinx_gallery.sorting import ExplicitOrder

import hophoop


class KeyLabels(BaseLabelStyle):
    """The bibliography's labels are the keys that docstrings cite."""

    def format_labels(self, sorted_entries):
        return [entry.key for entry in sorted_entries]


class ByKey(Style):
    default_label_style = KeyLabels


register_plugin("pybtex.style.formatting", "by_key", ByKey)

sys.path.insert(0, str(Path(__file__).parent / "_ext"))  # what Sphinx has no extension for

project = "hophoop"
author = "The hophoop developers"
copyright = "2026, The hophoop developers"
release = version = hophoop.__version__

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.autosummary",
    "typeset",
    "accessible",
    "matplotlib.sphinxext.plot_directive",
    "figures",
    "generated",
    "slides",
    "paper",
    "play",
    "lab_pictures",
    "gallery",
    "sphinx_gallery.gen_gallery",
    "numpydoc",
    "sphinxcontrib.bibtex",
    "sphinx_design",
    "sphinx_copybutton",
]
exclude_patterns = ["_build", "tables", "gallery/used"]  # tables are included by pages
templates_path = ["_templates"]
nitpicky = False
html_math_renderer = "mathml"

myst_enable_extensions = ["amsmath", "attrs_block", "colon_fence", "deflist", "dollarmath"]
myst_heading_anchors = 3

autosummary_generate = True
autodoc_typehints = "none"  # the docstrings give types and units
autodoc_member_order = "bysource"
numpydoc_show_class_members = False
numpydoc_xref_param_type = False

bibtex_bibfiles = ["references.bib"]
bibtex_default_style = "by_key"
bibtex_reference_style = "author_year"

# Each example is run; a warning of one is an error of the build.
sphinx_gallery_conf = {
    "examples_dirs": ["../examples/gallery"],
    "gallery_dirs": ["gallery"],
    "image_scrapers": ("gallery.drawings", "gallery.films"),
    "backreferences_dir": "gallery/used",
    "doc_module": ("hophoop",),
    "subsection_order": ExplicitOrder([f"../examples/gallery/{folder}" for folder in ("plots", "maps", "films")]),
    "within_subsection_order": "gallery.FromSimpleToHard",
    "capture_repr": (),
    "thumbnail_size": (400, 250),
    "download_all_examples": False,
    "show_memory": False,
    "show_signature": False,
    "min_reported_time": 600,
    "write_computation_times": False,
    "abort_on_example_error": True,
}

# A button copies what one types: without prompts, without the lines that a program prints.
copybutton_prompt_text = r">>> |\.\.\. |\$ "
copybutton_prompt_is_regexp = True
copybutton_only_copy_prompt_lines = True
copybutton_line_continuation_character = "\\"

# Pictures of tutorials, drawn by the code above them.
plot_html_show_formats = plot_html_show_source_link = False
plot_formats = ["svg"]

html_theme = "furo"
html_title = f"hophoop {version}"
html_static_path = ["_static", "../src/hophoop/article/fonts"]  # the font of formulas is the report's
html_css_files = ["site.css"]
html_logo = html_favicon = "_static/logo.svg"
