#!/usr/bin/env python3
"""The sources of the methods, spelt out for the help.

    sources.py            make src/design/sources.list from docs/bibliography.bib
    sources.py --check    1 when it is not what would be made
"""
import os
import re
import sys
import unicodedata

TOP = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..')
LIST = os.path.join(TOP, 'src', 'design', 'sources.list')
ACCENTS = {"'": '\u0301', '`': '\u0300', '"': '\u0308', '^': '\u0302', '~': '\u0303', 'c': '\u0327', 'v': '\u030c', '=': '\u0304', 'H': '\u030b', 'u': '\u0306', '.': '\u0307'}


def plain(text):
    """TeX as plain Unicode."""
    def accented(match):
        return unicodedata.normalize('NFC', match.group(2).replace('\\i', 'i') + ACCENTS[match.group(1)])
    text = re.sub(r'\\([\'`"^~=.])\s*\{?(\\i|\w)\}?', accented, text)
    text = re.sub(r'\\([cvHu])(?:\s*\{(\w)\}|\s+(\w))', lambda m: accented(re.match(r'\\(\w)\s*(\w)', '\\%s %s' % (m.group(1), m.group(2) or m.group(3)))), text)
    text = re.sub(r'\\(o|O|l|L|ss|ae|aa|AA)\b\s*', lambda m: {'o': 'ø', 'O': 'Ø', 'l': 'ł', 'L': 'Ł', 'ss': 'ß', 'ae': 'æ', 'aa': 'å', 'AA': 'Å'}[m.group(1)], text)
    text = text.replace('\\url', '').replace('---', ' - ').replace('--', '-').replace('\\&', '&').replace('~', ' ').replace('$', '')
    return ' '.join(re.sub(r'[{}]', '', text).split())


def people(text):
    """'Akima, Hiroshi and X, Y' as 'Hiroshi Akima and Y X'."""
    names = [plain(name) for name in re.split(r'\s+and\s+', text)]
    names = [' '.join(reversed(name.split(', ', 1))) if ', ' in name else name for name in names]
    return names[0] if len(names) == 1 else ', '.join(names[:-1]) + ' and ' + names[-1]


def fields_of(body):
    """The fields of an entry, braces counted."""
    fields, at = {}, 0
    while True:
        match = re.compile(r'\s*,?\s*(\w+)\s*=\s*\{').match(body, at)
        if not match:
            return fields
        depth, end = 1, match.end()
        while depth:
            depth += {'{': 1, '}': -1}.get(body[end], 0)
            end += 1
        fields[match.group(1).lower()] = body[match.end():end - 1]
        at = end


def citation(fields):
    get = lambda name: plain(fields.get(name, ''))
    parts = [people(fields['author'])] if 'author' in fields else []
    if 'editor' in fields and 'booktitle' not in fields:
        parts.append(people(fields['editor']) + ' (editors)')
    parts.append(get('title'))
    if 'edition' in fields:
        parts.append('edition ' + get('edition'))
    if 'booktitle' in fields:
        parts.append('in: ' + (people(fields['editor']) + ' (editors), ' if 'editor' in fields else '') + get('booktitle'))
    if 'journal' in fields:
        parts.append(get('journal') + (' ' + get('volume') if 'volume' in fields else '') + (' (%s)' % get('number') if 'number' in fields else ''))
    parts += [get(name) for name in ('school', 'institution', 'publisher', 'howpublished') if name in fields]
    if 'pages' in fields:
        parts.append('pages ' + get('pages'))
    parts.append(get('year'))
    if 'note' in fields:
        parts.append(get('note'))
    return ', '.join(part for part in parts if part)


def made():
    with open(os.path.join(TOP, 'docs', 'bibliography.bib'), encoding='utf-8') as file:
        text = file.read()
    lines = ['/* Made by tests/house/sources.py from docs/bibliography.bib: SOURCE(key, citation). */\n']
    for entry in re.split(r'\n(?=@)', text):
        head = re.match(r'@\w+\{([^,]+),', entry)
        if head:
            words = citation(fields_of(entry[head.end():])).replace('\\', '\\\\').replace('"', '\\"')
            lines.append('SOURCE("%s",\n       "%s")\n' % (head.group(1), words))
    return ''.join(lines)


def main():
    new = made()
    if '--check' in sys.argv[1:]:
        with open(LIST, encoding='utf-8') as file:
            same = file.read() == new
        if not same:
            print('src/design/sources.list is not what docs/bibliography.bib says; run tests/house/sources.py')
        return 0 if same else 1
    with open(LIST, 'w', encoding='utf-8') as file:
        file.write(new)
    return 0


if __name__ == '__main__':
    sys.exit(main())
