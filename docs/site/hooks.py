"""What the site needs beyond the pages as they are: the public headers, and pages whose links lead
out of the folder."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parents[2]
HEADERS = ROOT / "include" / "groundgrid"
LINK = re.compile(r"(?<!!)\[([^\]]+)\]\((?:\.\./)+([^)]+)\)")


def on_page_markdown(markdown, page, **_):
    if page.file.src_uri == "api/cpp.md":
        return markdown + "".join(section(each) for each in sorted(HEADERS.rglob("*.hpp")))
    if page.file.src_uri.startswith("api/"):
        return markdown

    def inside(link):
        text, place = link.groups()
        if not (ROOT / place.partition("#")[0]).exists():
            return link[0]  # for mkdocs to complain of
        return f"{text} (`{place}`)"

    return LINK.sub(inside, markdown)


def section(header):
    name = header.relative_to(ROOT / "include")
    return f"\n## {name}\n\n```cpp\n{header.read_text()}```\n"
