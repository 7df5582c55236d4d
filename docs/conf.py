"""The site: pages of this folder as HTML that needs no server, no script for formulas and nothing of another host."""

import re
import tomllib
from pathlib import Path

import latex2mathml.converter
from docutils import nodes

ROOT = Path(__file__).parent.parent
DOCS = ROOT / "docs"
OUTSIDE = re.compile(r"\[([^]]+)\]\((\.\./[^)#\s]+)(#[^)]*)?\)")
PLAYGROUND = re.compile(r"\[(!\[[^]]*\]\([^)]*\)|[^]]+)\]\(playground\.html\)")
HELP = re.compile(r"^\$ ((?:tribos)(?: [a-z]+)*) --help\n((?:>.*\n)+)", re.MULTILINE)
PICTURE = re.compile(r"^!\[([^]]*)\]\((pictures/[^)]+)\)", re.MULTILINE)

project = "Tribos"
author = "The Tribos developers"
copyright = author
release = version = tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))["workspace"]["package"]["version"]

extensions = ["myst_parser", "sphinx_copybutton", "sphinx_design"]
myst_enable_extensions = ["amsmath", "attrs_inline", "colon_fence", "deflist", "dollarmath"]
myst_heading_anchors = 4
exclude_patterns = ["site"]
# Commands without their prompts, and without what they print.
copybutton_prompt_text = "$ "

html_theme = "pydata_sphinx_theme"
html_title = "Tribos"
html_static_path = ["site"]
html_css_files = ["tribos.css"]
html_extra_path = ["playground.html"]
html_show_sourcelink = False
# Pages of their own have no section beside them.
html_sidebars = {"index": [], "install": [], "problems": []}
html_copy_source = False
html_math_renderer = "mathml"
html_theme_options = {
    "header_links_before_dropdown": 7,
    "navbar_align": "left",
    "secondary_sidebar_items": ["page-toc"],
    "show_nav_level": 1,
    "use_edit_page_button": False,
}


def formula(text: str, display: str) -> str:
    """MathML, with primes at their full size: fonts have them raised already."""
    made = latex2mathml.converter.convert(text, display=display)
    return re.sub(r"<msup>(<mi>[^<]*</mi>)<mi>(&#x0203[23];)</mi></msup>", r'\1<mo lspace="0" rspace="0">\2</mo>', made)


def inline(translator, node: nodes.math) -> None:
    translator.body.append(formula(node.astext(), "inline"))
    raise nodes.SkipNode


def block(translator, node: nodes.math_block) -> None:
    anchor = "".join(f'<span id="{name}"></span>' for name in node["ids"])
    number = f'<span class="eqno">({node["number"]})</span>' if node.get("number") else ""
    translator.body.append(f'<div class="formula">{anchor}{formula(node.astext(), "block")}{number}</div>')
    raise nodes.SkipNode


def read(app, name: str, text: list[str]) -> None:
    """Links out of this folder lead to the repository or, as long as that has no address, are paths in a clone."""
    repository = tomllib.loads((DOCS / "install.toml").read_text(encoding="utf-8"))["repository"]

    def link(found: re.Match[str]) -> str:
        path = ((DOCS / name).parent / found[2]).resolve()
        if path.is_relative_to(DOCS):
            return found[0]
        if not path.exists():
            raise FileNotFoundError(f"{name}: {found[0]}")
        place = path.relative_to(ROOT).as_posix()
        return f"[{found[1]}]({repository}/blob/main/{place})" if repository else f"{found[1]} (`{place}`)"

    text[0] = OUTSIDE.sub(link, text[0])
    # A page of its own, which Sphinx would take for a file to download.
    text[0] = PLAYGROUND.sub(r'<a href="playground.html">\1</a>', text[0])
    if name == "fronts/index":
        text[0] += "\n```{toctree}\n:hidden:\n:glob:\n\n*\n```\n"
    made = {"commands": commands, "gallery": gallery}
    if name in made:
        text[0] += made[name]()


def commands() -> str:
    """Helps of all commands, from the transcripts that the tests of the command are held to."""
    helps = {}
    for transcript in (ROOT / "cli/tests/transcripts").glob("*.txt"):
        for command, told in HELP.findall(transcript.read_text(encoding="utf-8")):
            helps[command] = re.sub(r"^> ?", "", told, flags=re.MULTILINE)
    first = helps.pop("tribos")
    sections = [f"\n```text\n{first}```\n"] + [f"\n## {name}\n\n```text\n{helps[name]}```\n" for name in sorted(helps)]
    return "".join(sections)


def gallery() -> str:
    """Every picture of the pages, each with its page."""
    cards = {}
    for page in sorted(DOCS.glob("*.md")):
        for words, picture in PICTURE.findall(page.read_text(encoding="utf-8")):
            link = f":img-top: {picture}\n:link: {page.stem}\n:link-type: doc\n"
            cards.setdefault(picture, f":::{{grid-item-card}}\n{link}\n{' '.join(words.split())}\n:::\n")
    return "\n::::{grid} 1 2 2 3\n:gutter: 3\n\n" + "\n".join(cards.values()) + "::::\n"


def setup(app) -> None:
    app.connect("source-read", read)
    app.add_html_math_renderer("mathml", inline_renderers=(inline, None), block_renderers=(block, None))
