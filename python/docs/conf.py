"""The API reference: ``sphinx-build -W docs OUT`` with the package installed."""

import bifdiag

project = "bifdiag"
author = "The authors of bifdiag"
release = bifdiag.__version__
extensions = ["sphinx.ext.autodoc", "sphinx.ext.autosummary", "sphinx.ext.napoleon"]
html_theme = "alabaster"
html_theme_options = {"description": "Heavy rigid bodies with a fixed point", "page_width": "1100px"}
autodoc_member_order = "bysource"
autodoc_typehints = "none"
napoleon_google_docstring = False
napoleon_use_rtype = False
napoleon_preprocess_types = False
napoleon_use_ivar = True
