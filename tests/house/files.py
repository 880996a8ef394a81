#!/usr/bin/env python3
"""The index of the files: what each is for, in the words with which it opens.

    files.py            make docs/files.md from the opening comments
    files.py --check    1 when it is not what would be made
"""
import os
import re
import sys

TOP = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..')
INDEX = os.path.join(TOP, 'docs', 'files.md')
LONGEST = 240

HEAD = '''# The files

What each source file is for, in the words with which it opens; made by `tests/house/files.py`. Search here for the thing you want to
change. The table ["Where is ..."](architecture.md#where-is-) leads to functions.
'''


def sources():
    """The sources and headers of the library and the command, and the checks of the house."""
    found = []
    for top, endings in (('cli', ('.c', '.h')), ('include', ('.h',)), ('src', ('.c', '.h')), ('tests/house', ('.py',))):
        for folder, _, names in os.walk(os.path.join(TOP, top)):
            found += [os.path.relpath(os.path.join(folder, name), TOP) for name in names if name.endswith(endings)]
    return sorted(found)


def opening(name):
    """The first sentence of the file's opening comment; a program's docstring."""
    with open(os.path.join(TOP, name), encoding='utf-8') as file:
        text = file.read(4000)
    if name.endswith('.py'):
        found = re.search(r'"""(.*?)"""', text, re.S)
    else:
        found = re.match(r'\s*/\*+(.*?)\*/', text, re.S)
    if not found:
        return None
    words = ' '.join(re.sub(r'^\s*\*\s?', '', line) for line in found.group(1).strip().split('\n'))
    words = re.sub(r'\s+', ' ', words)
    sentence = re.match(r'(.*?[^.]\.)(\s+[A-Z`(]|\s*$)', words)
    said = sentence.group(1) if sentence else words
    return said if len(said) <= LONGEST else said[:LONGEST].rsplit(' ', 1)[0] + ' ...'


def made():
    """The index, whole."""
    rooms = {}
    names = sources()
    for name in names:
        # A header of the same name says the same again.
        if name.endswith('.h') and name[:-2] + '.c' in names:
            continue
        said = opening(name)
        if said:
            rooms.setdefault(os.path.dirname(name), []).append((name, said))
    text = HEAD
    for room in sorted(rooms):
        text += f'\n## {room}\n\n'
        for name, said in rooms[room]:
            text += f'- `{name}`: {said}\n'
    return text


def main():
    wanted = made()
    if sys.argv[1:] == ['--check']:
        with open(INDEX, encoding='utf-8') as file:
            if file.read() == wanted:
                return 0
        print('docs/files.md is not what the files say: run tests/house/files.py')
        return 1
    with open(INDEX, 'w', encoding='utf-8') as file:
        file.write(wanted)
    return 0


if __name__ == '__main__':
    sys.exit(main())
