#!/usr/bin/env python3
"""Messages count from 1.

    counting.py    1 when a message prints an index as it is, with the places

An index is what follows the name of a thing ("point %d", "point (%d, %d)"): its argument ends with '+ 1' (or + 2, + 3), begins with number, or is in the
list below of numbers that count from 1 already.
"""
import glob
import os
import re
import sys

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..')
ROOMS = ('body', 'design', 'fair', 'inspect', 'mesh', 'model', 'numeric', 'picture', 'shape', 'spline')
THINGS = (r'(?:points?|tangents?|weights?|sections?|curves?|corners?|rows?|edges?|faces?|knots?|spans?|sides?|vertex|'
          r'vertices|loops?|triangles?|rails?|pieces?|stations?|constraints?|conditions?|unknown|coordinates?|datum|levels?|values?|parameters?|number|places?|cubics?|lines?|layers?|breaks?|tensions?|equation|radius|lengths?|ends?|inequality)')
STRING = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
STRINGS = re.compile(r'"(?:[^"\\\n]|\\.)*"(?:\s*"(?:[^"\\\n]|\\.)*")*')
CONVERSION = re.compile(r'%(?:%|[-+ #0]*(\*|\d+)?(?:\.(\*|\d+))?(?:hh|h|ll|l|z|j|t)?([diouxXeEfgGcsp]))')
# Numbers that count from 1 before they come to the message, or are no index: (end of the path, argument).
FROM_ONE = {
    ('features/surfaces/coons.c', 'found->slope_corner'), ('features/surfaces/coons.c', 'found->corner'),
    ('features/surfaces/coons.c', 'found->twist_corner'), ('features/through/constrained.c', 'point'),
    ('shared/through.c', 'argument->items[i].count'), ('bent/nonlinear.c', '(int)kind'),
    ('boundary/ribbon.c', '(int)edge'), ('linear/constrained.c', '-of'), ('near/approximate_conditions.c', '(int)o->side'),
    ('boundary/coons_patch.c', 'corner_number(i, j)'), ('boundary/edges_in_order.c', 'number'),
    ('boundary/edges_in_order.c', 'corner'), ('boundary/edges_in_order.c', 'from'), ('boundary/edges_in_order.c', 'to'),
    ('fill/triangle_ribbons.c', 'number'), ('surface_change/blend.c', '(int)e->edge'),
    ('surface_change/extend.c', '(int)edge'), ('shared/boundary.c', 'side'), ('boundary/coons_patch.c', 'p->dimension'),
    ('curve_change/cut_corners.c', 'number(w, k)'), ('curve_change/cut_corners.c', 'number'),
    ('curve_change/cut_corners.c', 'number(w, (k + w->corners - 1) % w->corners)'),
    ('fill/triangle_ribbons.c', 'numbers[0]'), ('fill/triangle_ribbons.c', 'numbers[1]'), ('surface/nurbs.c', 'k'),
    ('surface/nurbs.c', 'l'), ('text/yaml.c', 'before->line'),
}


def arguments(text, at):
    """What follows the format up to the end of its call, cut at commas; None where it is not in a call."""
    depth, current, found, i = 0, '', [], at
    while i < len(text):
        c = text[i]
        if c in '"\'':
            end = i + 1
            while text[end] != c:
                end += 2 if text[end] == '\\' else 1
            current += text[i:end + 1]
            i = end + 1
            continue
        depth += (c in '([{') - (c in ')]}')
        if depth < 0:
            return (found + [current])[1:]
        if c == ';' and depth == 0:
            return None
        if c == ',' and depth == 0:
            found, current = found + [current], ''
        else:
            current += c
        i += 1
    return None


def indices(form, given):
    """The arguments of a format that follow the name of a thing, in order."""
    place, end, pair = 0, 0, False
    for match in CONVERSION.finditer(form):
        if match.group(0) == '%%':
            continue
        place += (match.group(1) == '*') + (match.group(2) == '*')
        before = form[end:match.start()]
        opens = re.search(r'(?<![\w-])' + THINGS + r'(?: at)? \($', before)
        follows = re.search(r'(?<![\w-])' + THINGS + ' $', before) or opens or (pair and before == ', ')
        if match.group(3) in 'diu' and follows and place < len(given):
            yield ' '.join(given[place].split())
        pair = bool(opens)
        place, end = place + 1, match.end()


def main():
    found = []
    for room in ROOMS:
        for path in sorted(glob.glob(os.path.join(ROOT, 'src', room, '**', '*.c'), recursive=True)):
            with open(path, encoding='utf-8') as file:
                text = file.read()
            for match in STRINGS.finditer(text):
                form = ''.join(part.group(1) for part in STRING.finditer(match.group(0)))
                where = '%s:%d' % (os.path.relpath(path, ROOT), text.count('\n', 0, match.start()) + 1)
                given = arguments(text, match.end()) if '%' in form and text[match.end():].lstrip()[:1] == ',' else None
                for argument in indices(form, given or []):
                    known = any(path.endswith(end) and argument == name for end, name in FROM_ONE)
                    if not known and not re.search(r'^numbers?\b|\+ [123]$', argument):
                        found.append('%s: "%s" prints the index %s' % (where, form[:60], argument))
    print('\n'.join(found))
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main())
