# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Wrong edits of a source by rule. The sources are formatted: an operator between two spaces has two operands."""
import re
from dataclasses import dataclass

# Comments, texts, preprocessor lines, messages that are thrown, and deal.II's Assert, which a release build does not have.
HIDDEN = {".py": r'"""(?:\\.|[^\\])*?"""|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|#[^\n]*'}
HIDDEN_CPP = (r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|(?<!\d)\'(?:\\.|[^\'\\\n])+\'|'
              r'^[ \t]*#(?:\\\n|[^\n])*|\bAssert\(.*?\);|\bthrow\b[^;]*;')
# Members with a value and default arguments.
DEFAULT = re.compile(r"^ *(?!return |using |const )(?:[\w:]+(?:<[^;()]*>)? +)+[*&]?\w+(?:\[\w+\])*(?: *=[^=][^;]*|\{[^;]*\})?"
                     r"(?:, *\w+(?: *= *[^;,]*|\{[^;,]*\}))*;|(?<=\w) += +[^,;(){}]+(?:\{\}|\(\))?(?=[,)])", re.M)

EXCHANGED = {"+": "-", "-": "+", "*": "/", "/": "*", "<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "==",
             "&&": "||", "||": "&&", "+=": "-=", "-=": "+=", "*=": "/=", "/=": "*=", "and": "or", "or": "and",
             "min": "max", "max": "min"}
OPERATOR = re.compile(r"(?<=\s)(?:[-+*/]=?|[<>]=?|[!=]=|&&|\|\||and|or)(?=\s)")
SIGN = re.compile(r"(?:(?<=[(,=?:{\[])|(?<=return)|(?<=[-+*/<>=?:,] )|(?<=return ))-(?=[\w(.])")
NEGATION = re.compile(r"!(?=[\w(:])|(?<=\b)not (?!in\b)")
BOUND = re.compile(r"\b(?:min|max)(?=\(|<\w+>\(|_element\b)")
# Numbers, but no arguments of templates.
NUMBER = re.compile(r"(?<![\w.<])(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?![\w.>'])")
# What ends a function or a turn of a loop under a condition.
EXIT = re.compile(r"(?:(?<=\))|(?<=\belse))(\s+)((?:return\b[^;]*|continue);)")
EXIT_PY = re.compile(r"(?<=:)([ \t]*\n +)(return\b[^\n]*|continue)(?=\n+ *\S)")


@dataclass(frozen=True)
class Mutant:
    file: str
    begin: int
    end: int
    line: int
    old: str
    new: str
    text: str  # the whole line

    def apply(self, content):
        return content[:self.begin] + self.new + content[self.end:]

    def __str__(self):
        return f'{self.file}:{self.line}: {" ".join(self.old.split())} -> {self.new.strip() or "nothing"}   [{self.text}]'


def hide(content, suffix, defaults):
    """The text with spaces where no edit is made."""
    def blank(match):
        return re.sub(r"[^\n]", " ", match[0])

    content = re.sub(HIDDEN.get(suffix, HIDDEN_CPP), blank, content, flags=re.S | re.M)
    return content if defaults or suffix != ".h" else DEFAULT.sub(blank, content)


def change_number(text):
    if float(text) in (0., 1.):
        return [("1" if float(text) == 0. else "0") + ("." if "." in text else "")]
    return [f"(1.01 * {text})", f"(2. * {text})"] if re.search("[.eE]", text) else [str(int(text) + 1)]


def make_mutants(file, content, defaults=False):
    """All mutants of a source, in the order of its text."""
    suffix = file[file.rfind("."):]
    shown = hide(content, suffix, defaults)
    edits = [(match.start(), match.end(), EXCHANGED[match[0]]) for rule in (OPERATOR, BOUND) for match in rule.finditer(shown)]
    edits += [(match.start(), match.end(), "") for rule in (SIGN, NEGATION) for match in rule.finditer(shown)]
    edits += [(match.start(), match.end(), new) for match in NUMBER.finditer(shown) for new in change_number(match[0])]
    edits += [(match.start(2), match.end(2), "pass" if suffix == ".py" else ";")
              for match in (EXIT_PY if suffix == ".py" else EXIT).finditer(shown)]
    mutants = []
    for begin, end, new in sorted(edits):
        line = content.count("\n", 0, begin) + 1
        mutants.append(Mutant(file, begin, end, line, content[begin:end], new, content.splitlines()[line - 1].strip()))
    return mutants
