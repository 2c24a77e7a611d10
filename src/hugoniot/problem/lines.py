"""Which line of a TOML text holds which key: the parser of the standard library does not tell.

The text has been parsed already, so it is known to be valid TOML; this scanner only walks over it. Keys are paths from the
root, with the index of an array element as a number: ("region", 0, "from").
"""

import re

_BARE = re.compile(r"[A-Za-z0-9_-]+")
_BLANK = re.compile(r"(?:[ \t\r\n,]+|#[^\n]*)*")
_NEXT, _NEXT_LITERAL = re.compile(r'["\\]|\Z'), re.compile(r"'|\Z")     # where a text may end, or an escape begins
_SCALAR = re.compile(r"[^,\]}\n#]*")
_ESCAPES = {"b": "\b", "t": "\t", "n": "\n", "f": "\f", "r": "\r", '"': '"', "\\": "\\", "e": "\x1b"}
_DEEPEST = 60


def key_lines(text: str) -> dict[tuple, int]:
    """Line (from 1) of every key, table header and array element of a valid TOML text."""
    return _Scanner(text).scan()


def line_finder(text: str):
    """Function from a key path to its line; of a key that is not there, the line of the nearest table around it, or None."""
    found: list[dict[tuple, int]] = []   # looked for when the first message needs a line: a sound deck has none

    def line_of(path: tuple) -> int | None:
        if not found:
            try:
                found.append(key_lines(text))
            except (ValueError, IndexError):  # a message without a line number beats no message
                found.append({})
        for length in range(len(path), 0, -1):
            if path[:length] in found[0]:
                return found[0][path[:length]]
        return None

    return line_of


class _Scanner:
    def __init__(self, text: str):
        self.text, self.at, self.line, self.counted = text, 0, 1, 0
        self.lines: dict[tuple, int] = {}
        self.elements: dict[tuple, int] = {}

    def scan(self) -> dict[tuple, int]:
        table: tuple = ()
        while self.blank() < len(self.text):
            if self.text.startswith("[[", self.at):
                table = self.header(2)
                index = self.elements.get(table, -1) + 1
                self.elements[table] = index
                self.note(table)
                table = (*table, index)
                self.note(table)
            elif self.text[self.at] == "[":
                table = self.header(1)
                for length in range(1, len(table) + 1):
                    self.note(table[:length])
            else:
                self.pair(table, 0)
        return self.lines

    def blank(self) -> int:
        self.at = _BLANK.match(self.text, self.at).end()  # type: ignore[union-attr]  (matches the empty text)
        return self.at

    def note(self, path: tuple) -> None:
        self.line += self.text.count("\n", self.counted, self.at)
        self.counted = self.at
        self.lines.setdefault(path, self.line)

    def header(self, brackets: int) -> tuple:
        self.at += brackets
        path = self.resolved(self.dotted())
        self.at = self.text.index("]", self.at) + brackets
        return path

    def resolved(self, keys: tuple) -> tuple:
        """A header path with the running index of each array of tables it passes through."""
        path: tuple = ()
        for i, key in enumerate(keys):
            path = (*path, key)
            if i < len(keys) - 1 and path in self.elements:
                path = (*path, self.elements[path])
        return path

    def dotted(self) -> tuple:
        keys = []
        while True:
            self.space()
            if self.text[self.at] in "\"'":
                keys.append(self.string())
            else:
                match = _BARE.match(self.text, self.at)
                if match is None:
                    raise ValueError("not a key")
                keys.append(match[0])
                self.at = match.end()
            self.space()
            if self.text[self.at : self.at + 1] != ".":
                return tuple(keys)
            self.at += 1

    def space(self) -> None:
        while self.text[self.at : self.at + 1] in (" ", "\t"):
            self.at += 1

    def pair(self, table: tuple, depth: int) -> None:
        start = self.at
        keys = self.dotted()
        end, self.at = self.at, start
        for i in range(len(keys)):
            self.note((*table, *keys[: i + 1]))
        self.at = self.text.index("=", end) + 1
        self.value((*table, *keys), depth)

    def value(self, path: tuple, depth: int) -> None:
        self.space()
        if depth > _DEEPEST:
            raise ValueError("nested too deeply")
        start = self.text[self.at : self.at + 1]
        if start in ("'", '"'):
            self.string()
        elif start == "[":
            self.at += 1
            index = 0
            while self.text[self.blank()] != "]":
                self.note((*path, index))
                self.value((*path, index), depth + 1)
                index += 1
            self.at += 1
        elif start == "{":
            self.at += 1
            while self.text[self.blank()] != "}":
                self.pair(path, depth + 1)
            self.at += 1
        else:
            self.at = _SCALAR.match(self.text, self.at).end()  # type: ignore[union-attr]

    def string(self) -> str:
        quote = self.text[self.at]
        long = self.text.startswith(quote * 3, self.at)
        mark = quote * 3 if long else quote
        self.at += len(mark)
        start = self.at
        while not self.text.startswith(mark, self.at):
            if self.at >= len(self.text):
                raise ValueError("a string is not closed")
            if quote == '"' and self.text[self.at] == "\\":
                self.at += 2
            else:
                self.at = (_NEXT if quote == '"' else _NEXT_LITERAL).search(self.text, self.at + 1).start()  # type: ignore[union-attr]
        while long and self.text.startswith(quote, self.at + 3):  # up to two quotes may stand before the closing three
            self.at += 1
        content = self.text[start : self.at]
        self.at += len(mark)
        return re.sub(r"\\(.)", lambda m: _ESCAPES.get(m[1], m[1]), content) if quote == '"' else content
