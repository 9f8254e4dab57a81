# SPDX-License-Identifier: MIT
"""How Sphinx makes the site; tools/build_docs.py prepares the pages and runs it."""

import os
import re
from pathlib import Path

_ROOT = Path(os.environ["HODOGRAPH_SOURCE"])
_HEADER = (_ROOT / "include/hodograph/foundation/version.hpp").read_text(encoding="utf-8")

project = "Hodograph"
author = "Hodograph contributors"
copyright = "Hodograph contributors; MIT licence"
release = version = re.search(r'VERSION_STRING "([^"]+)"', _HEADER)[1]

extensions = ["myst_parser", "sphinx.ext.mathjax"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 4
myst_update_mathjax = False
exclude_patterns = ["**/pictures/*.md"]
suppress_warnings = ["misc.highlighting_failure"]  # shortened JSON is not JSON

# Debian's MathJax, copied into the site: formulas need no network.
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_CHTML"
mathjax2_config = {
    "messageStyle": "none",
    "showMathMenu": False,
    "tex2jax": {"inlineMath": [["\\(", "\\)"]], "displayMath": [["\\[", "\\]"]],
                "processClass": "tex2jax_process|mathjax_process|math"},
}

html_theme = "alabaster"
html_title = f"Hodograph {release}"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_extra_path = [os.environ["HODOGRAPH_SITE_EXTRA"]]
html_copy_source = False
html_theme_options = {
    "description": "Pythagorean-hodograph curves, paths and frames",
    "fixed_sidebar": True,
    "page_width": "1240px",
    "sidebar_width": "250px",
    "body_text_align": "left",
    "body_max_width": "960px",
}
html_sidebars = {"**": ["about.html", "searchbox.html", "localtoc.html", "navigation.html"]}
smartquotes = False
pygments_style = "friendly"
add_module_names = False
python_use_unqualified_type_names = True
toc_object_entries = False
nitpicky = False
