# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Ways to spoil texts and bytes. Each takes a generator of random numbers; the same one makes the same mutant."""
import re

SMALL_BODY = """  subsection Body a
    set mesh = block
    set elements x = 2
    set elements y = 1
    set elements z = 1
  end
"""
NUMBERS = ["0", "-1", "1", "-0", "2", "1e9", "1e6", "1e300", "1e-300", "1e400", "-1e9", "nan", "-nan", "inf", "-inf", "0.5",
           "1e-12", "2147483647", "2147483648", "4294967295", "4294967296", "-2147483648", "9223372036854775807",
           "18446744073709551615", "99999999999999999999999", "1,5", "0x10", "1e", "1.2.3", "--1", "1 2", "", "1e5000"]
UNITS = ["mm", "m", "s", "ms", "deg", "rad", "rpm", "N m", "N", "MPa", "GPa", "kg/m^3", "%", "furlong", "1/s", "Hz", "kg"]
NUMBER = re.compile(r"(?<![\w.])[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?![\w.])")
BYTES = [b"\xff", b"\x00", b"\xc3\x28", b"\xe2\x82", b"\xef\xbb\xbf", b"\xf0\x9f\x92\xa9", b"\x1b[31m", b"\r", b"\x80" * 9]


def pick(rng, items):
    return items[rng.randrange(len(items))]


def misspell(rng, word):
    """One letter less, more, another, or two exchanged."""
    if not word:
        return "x"
    place, how = rng.randrange(len(word)), rng.randrange(5)
    if how == 0:
        return word[:place] + word[place + 1:]
    if how == 1:
        return word[:place] + chr(rng.randrange(33, 127)) + word[place:]
    if how == 2:
        return word[:place] + chr(rng.randrange(97, 123)) + word[place + 1:]
    if how == 3:
        return word[:place] + word[place:place + 2][::-1] + word[place + 2:]
    return pick(rng, [word.upper(), word * 40, word + " ", word[::-1]])


def change_number(rng, text):
    """One of the text's numbers becomes an extreme one, or is scaled; the text itself where it has none."""
    found = list(NUMBER.finditer(text))
    if not found:
        return text
    one = pick(rng, found)
    number = pick(rng, NUMBERS)
    if rng.random() < 0.3:
        number = repr(float(one.group()) * pick(rng, [-1, 0.1, 10, 1e3, 1e-3, 1e6, 0.999]))
    return text[:one.start()] + number + text[one.end():]


def change_lines(rng, lines):
    """One line goes, comes twice or moves; name of what was done. Lists are changed in place."""
    if not lines:
        return "nothing to change"
    place, how = rng.randrange(len(lines)), pick(rng, ["delete", "repeat", "swap", "move", "block", "cut"])
    if how == "delete":
        del lines[place]
    elif how == "repeat":
        lines[place:place] = [lines[place]] * pick(rng, [1, 1, 1, 20])
    elif how == "swap":
        other = rng.randrange(len(lines))
        lines[place], lines[other] = lines[other], lines[place]
    elif how == "move":
        line = lines.pop(place)
        lines.insert(rng.randrange(len(lines) + 1), line)
    elif how == "block":
        del lines[place:place + rng.randrange(1, 20)]
    else:
        del lines[place:]
    return f"{how} line {place + 1}"


def change_bytes(rng, content):
    """Bits, bytes or a piece of the file; what was done and the new content."""
    content = bytearray(content)
    how = pick(rng, ["flip", "insert", "truncate", "overwrite", "remove", "empty" if rng.random() < 0.1 else "flip"])
    place = rng.randrange(len(content)) if content else 0
    if how == "flip" and content:
        for _ in range(pick(rng, [1, 1, 4, 30])):
            content[rng.randrange(len(content))] ^= 1 << rng.randrange(8)
    elif how == "insert":
        content[place:place] = pick(rng, BYTES)
    elif how == "truncate":
        del content[place:]
    elif how == "overwrite":
        content[place:place + 8] = pick(rng, [b"\x00" * 8, b"\xff" * 8, b"\x00" * 6 + b"\xf8\x7f", b"\xff" * 7 + b"\x7f"])
    elif how == "remove":
        del content[place:place + rng.randrange(1, 200)]
    else:
        content.clear()
    return f"{how} at byte {place}", bytes(content)


def mutate_text(rng, content, word_of):
    """A file of lines with words and numbers: what was done and the new content. @p word_of: other words that such
    files have."""
    notes = []
    for _ in range(pick(rng, [1, 1, 1, 2, 4])):
        how = rng.random()
        if how < 0.2:
            note, content = change_bytes(rng, content)
            notes.append(note)
            continue
        lines = content.decode("utf-8", "surrogateescape").split("\n")
        if how < 0.45:
            notes.append(change_lines(rng, lines))
        else:
            place = rng.randrange(len(lines))
            # Headers are few among many lines of numbers.
            if rng.random() < 0.4:
                heads = [k for k, line in enumerate(lines) if re.search("[A-Za-z$*]", line)]
                place = min(pick(rng, heads) + rng.randrange(3), len(lines) - 1) if heads else place
            line = lines[place]
            if how < 0.75:
                lines[place] = change_number(rng, line)
            elif how < 0.9 and line.split():
                words = re.split(r"(\s+|,)", line)
                k = rng.randrange(len(words))
                words[k] = pick(rng, [misspell(rng, words[k]), pick(rng, word_of), "", pick(rng, NUMBERS)])
                lines[place] = "".join(words)
            else:
                lines[place] = pick(rng, word_of)
            notes.append(f"line {place + 1} is {lines[place][:80]!r}")
        content = "\n".join(lines).encode("utf-8", "surrogateescape")
    return "; ".join(notes), content
