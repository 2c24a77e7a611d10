"""Labels of errors in the printed sources, such as W-E4, on the pages of laws and tools: spelled out, and explained below."""

import re

LABEL = r"[WKHSJ]-E\d+"
_BARE = re.compile(rf"\(({LABEL}(?:, {LABEL})*)\)")
# documents that are cited by a short name alone
_SHORT = {"Wilkins": r"\bWilkins, (?:appendix|[AB]\.)", "KB codes": r"\bKB codes,", "Jordan": r"\bJordan,? (?:\(?2011|eq\.)"}


def spelled_out(text: str) -> str:
    """Text in which a label that stands alone in brackets is called a source error."""
    return _BARE.sub(lambda m: f"(source error{'s' if ',' in m[1] else ''} {m[1]})", text)


def explained(lines: list[str], errors: str) -> list[str]:
    """A page with its labels spelled out, and a line on where they are listed or, without any, where short names of sources are; `errors`
    is the page that lists both."""
    text = spelled_out("\n".join(lines))
    found = sorted(set(re.findall(rf"\b{LABEL}\b", text)))
    listed = f"[errors in the printed sources]({errors})"
    if found:
        subject = f"{found[0]} refers" if len(found) == 1 else f"Labels such as {found[0]} refer"
        return [text, f"{subject} to the list of {listed}, which also identifies the source documents.", ""]
    cited = [name for name, pattern in _SHORT.items() if re.search(pattern, text)]
    names = " and ".join(cited)
    return [text, *([f"For the document{'s' if cited[1:] else ''} cited as {names}, see the list of {listed}.", ""] if cited else [])]
