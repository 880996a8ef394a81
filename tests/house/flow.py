#!/usr/bin/env python3
"""The drawing of the rooms and of what uses what, from the includes: docs/flow.dot, and docs/flow.svg by dot.

    flow.py           write docs/flow.dot, and docs/flow.svg where there is a dot (package graphviz)
    flow.py --check   is docs/flow.dot what the includes say today?

An arrow runs from a room to one that uses it, as data do; where a longer path says the same, it is left out.
The rooms of src/shape are drawn one by one, all others as whole folders.
"""
import collections
import os
import re
import shutil
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from source import ROOT, read, tracked  # noqa: E402

ORDER = ['base', 'numeric', 'spline', 'inspect', 'shape', 'body', 'mesh', 'model', 'fair', 'loft', 'hydrostatics',
         'exchange', 'picture', 'design', 'cli']
ABOUT = {'base': 'memory, statuses, text, files', 'numeric': 'polynomials, systems, exact signs',
         'spline': 'curves and surfaces as values', 'inspect': 'what is true of a shape',
         'body': 'faces, shells, solids', 'mesh': 'triangles within a chord',
         'model': 'named shapes with a unit;\\ntables of offsets', 'fair': 'fairing within bounds', 'loft': 'fair hulls\\nfrom tables',
         'hydrostatics': 'how a hull floats',
         'exchange': 'files: one room a format', 'picture': 'drawings and pictures',
         'design': 'the document, its features and outputs', 'cli': 'the command batten'}


def node_of(path):
    parts = path.split('/')
    if parts[0] == 'src':
        parts = parts[1:]
    if parts[0] == 'shape':
        return 'shape/' + parts[1] if len(parts) > 2 else None
    return parts[0]


def arrows():
    """used -> {users}."""
    found = collections.defaultdict(set)
    for path in tracked('src/*.[ch]', 'cli/*.[ch]'):
        user, text = node_of(path), read(path)
        if not user:
            continue
        for include in re.findall(r'^#include "([^"]+)"', text, re.M):
            used = node_of('src/' + include) if os.path.exists(os.path.join(ROOT, 'src', include)) else None
            if used and used != user:
                found[used].add(user)
    # The public headers stand for the rooms that define what they declare.
    homes = collections.defaultdict(set)
    for path in tracked('src/*.c'):
        for name in re.findall(r'^[a-z][\w *]*\b(batten_\w+)\(', read(path), re.M):
            homes[name].add(node_of(path))
    declared = {h: set(re.findall(r'\b(batten_\w+)\(', read(f'include/batten/{h}.h')))
                for h in {os.path.basename(p)[:-2] for p in tracked('include/batten/*.h')}}
    for user in ('picture', 'design', 'cli'):
        text = ' '.join(read(p) for p in tracked(f'src/{user}/*.c', f'{user}/*.c'))
        called = set(re.findall(r'\b(batten_\w+)\b', text))
        for names in declared.values():
            for name in names & called:
                for home in homes[name]:
                    if home and home != user:
                        found[home].add(user)
    return found


def reduced(found):
    """Without arrows that a longer path makes superfluous; those that close a circle stay."""
    def reaches(a, b, without):
        seen, waiting = {a}, [a]
        while waiting:
            node = waiting.pop()
            for other in found.get(node, ()):
                if (node, other) == without or other in seen:
                    continue
                if other == b:
                    return True
                seen.add(other)
                waiting.append(other)
        return False
    rank = {name: i for i, name in enumerate(ORDER)}

    def forward(a, b):
        return rank[a.split('/')[0]] <= rank[b.split('/')[0]]
    return {(a, b) for a in found for b in found[a] if forward(a, b) and not reaches(a, b, (a, b))}


def drawing():
    found = arrows()
    nodes = sorted(set(found) | {u for users in found.values() for u in users})
    lines = ['// Written by tests/house/flow.py from the includes; a test compares.', 'digraph flow {',
             '  rankdir=TB; nodesep=0.25; ranksep=0.45;',
             '  node [shape=box, style="rounded,filled", fillcolor="#f4efe4", color="#8a7350", fontname="DejaVu Sans", '
             'fontsize=10];', '  edge [color="#5a6b7a", arrowsize=0.6];']
    for node in nodes:
        if '/' not in node:
            lines.append(f'  "{node}" [label="{node}\\n{ABOUT.get(node, "")}"];')
    lines.append('  subgraph cluster_shape { label="shape: how shapes come to be"; fontname="DejaVu Sans"; fontsize=10; '
                 'color="#8a7350"; style=rounded;')
    lines += [f'    "{node}" [label="{node.split("/")[1]}", fillcolor="#e4ecf4"];' for node in nodes if '/' in node]
    lines.append('  }')
    lines += [f'  "{a}" -> "{b}";' for a, b in sorted(reduced(found))]
    return '\n'.join(lines + ['}', ''])


def main():
    path, text = os.path.join(ROOT, 'docs/flow.dot'), drawing()
    if sys.argv[1:] == ['--check']:
        if not os.path.exists(path) or read('docs/flow.dot') != text:
            print('docs/flow.dot is not what the includes say; run tests/house/flow.py and commit docs/flow.*')
            return 1
        return 0
    with open(path, 'w', encoding='utf-8') as file:
        file.write(text)
    if shutil.which('dot'):
        svg = subprocess.check_output(['dot', '-Tsvg', path], text=True)
        with open(os.path.join(ROOT, 'docs/flow.svg'), 'w', encoding='utf-8') as file:
            file.write(re.sub(r'<!-- Generated by graphviz.*?-->\n?', '', svg, flags=re.S))
    else:
        print('docs/flow.svg was not drawn: there is no dot (package graphviz)')
    return 0


if __name__ == '__main__':
    sys.exit(main())
