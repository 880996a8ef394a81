#!/usr/bin/env python3
"""The files that the documents name exist (NAME in capitals stands for any), and the journeys of docs/architecture.md climb at most five times.

A journey is a section below "Three journeys"; its files are those it names, in order. A climb is a step to a file of
a room above that of the file before.
"""
import os
import re
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from flow import ORDER  # noqa: E402
from source import ROOT, read, tracked  # noqa: E402

MOST_CLIMBS = 5


def room(path):
    return (path.split('/')[1] if path.startswith('src/') else path.split('/')[0]) if path else None


def main():
    bad = []
    for page in tracked('*.md'):
        if page == 'CHANGELOG.md':
            continue
        text = read(page)
        for path in re.findall(r'`((?:src|cli|include|tests|docs|examples|fuzz|bench|cmake)/[\w./-]*[\w/])`', text):
            if not os.path.exists(os.path.join(ROOT, path)) and not re.search('[A-Z]{3}$', path):
                bad.append(f'{page}: there is no {path}')
        for link in re.findall(r'\]\(([^)#:\s]+)(?:#[^)]*)?\)', text):
            if not os.path.exists(os.path.join(ROOT, os.path.dirname(page), link)):
                bad.append(f'{page}: the link to {link} leads nowhere')
    journeys = read('docs/architecture.md').split('## Three journeys')[1].split('\n## ')[0].split('\n### ')[1:]
    if len(journeys) < 3:
        bad.append('docs/architecture.md has fewer than three journeys')
    for journey in journeys:
        title, climbs, last = journey.split('\n')[0], 0, None
        for path in re.findall(r'`((?:src|cli)/[\w./-]+\.\w+)`', journey):
            rank = ORDER.index(room(path))
            climbs += last is not None and rank > last
            last = rank
        print(f'{title}: climbs {climbs} times')
        if climbs > MOST_CLIMBS:
            bad.append(f'{title}: climbs {climbs} times, {MOST_CLIMBS} are allowed')
    print('\n'.join(bad))
    return bool(bad)


if __name__ == '__main__':
    sys.exit(main())
