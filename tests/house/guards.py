#!/usr/bin/env python3
"""Figures of the house, each held to a budget that may only fall.

    guards.py [--list] [--build BUILD] GUARD...    check these guards; without any: all
    guards.py --rise                               no budget was ever raised

The budgets stand in budgets.txt beside this file. A figure above its budget fails and its places are listed;
one below it passes and says what the budget can be lowered to.  `--list` prints the places in any case.
A guard that misses its tool (ctags, nm) ends with 77, which ctest shows as skipped.
"""
import argparse
import collections
import json
import os
import re
import shutil
import statistics
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from source import ROOT, blanked, read, tracked  # noqa: E402

BUDGETS = 'tests/house/budgets.txt'
PRODUCT = ('src/*.c', 'src/*.h', 'cli/*.c', 'cli/*.h')
VAGUE = {'add', 'apply', 'begin', 'check', 'do', 'done', 'end', 'finish', 'get', 'give', 'go', 'hand', 'hand_over',
         'handle', 'keep', 'look', 'make', 'measure', 'move', 'next', 'note', 'one', 'part', 'place', 'process', 'put',
         'rest', 'run', 'say', 'set', 'show', 'start', 'step', 'take', 'tell', 'try', 'turn', 'use', 'work'}


class Skip(Exception):
    pass


def needs(tool, package):
    if not shutil.which(tool):
        raise Skip(f'{tool} is missing (package {package})')


# ---- files and folders ----

def files(_):
    long, large = [], collections.Counter()
    for path in tracked(*PRODUCT, 'include/*.h'):
        large[os.path.dirname(path)] += 1
        lines = read(path).count('\n')
        if lines > 400:
            long.append((lines, f'{path}: {lines} lines'))
    tests = [(n, f'{p}: {n} lines') for p in tracked('tests/*.c', 'tests/*.h') if (n := read(p).count('\n')) > 400]
    yield 'files-over-400-lines', len(long), [t for _, t in sorted(long, reverse=True)]
    yield 'tests-over-400-lines', len(tests), [t for _, t in sorted(tests, reverse=True)]
    yield 'largest-folder', max(large.values()), [f'{d}: {n} files' for d, n in large.most_common(10)]


def openings(_):
    """Sources whose first lines do not say what they are."""
    bare = []
    for path in tracked(*PRODUCT, 'include/*.h'):
        text = read(path)
        if path.endswith('.h'):
            text = re.sub(r'\A\s*#ifndef \w+\s*\n\s*#define \w+\s*\n', '', text)
        text = re.sub(r'\A(\s*#define _\w+ \d+\n)*', '', text)
        if not re.match(r'\s*/[*/]', text):
            bare.append(path)
    yield 'sources-without-opening', len([p for p in bare if not p.startswith('include/')]), bare
    yield 'headers-without-opening', len([p for p in bare if p.startswith('include/')]), bare


def named_tests(_):
    """Sources that no test file of their name tests."""
    have = set(tracked('tests/*.c'))
    missing = []
    for path in tracked('src/*.c', 'cli/*.c'):
        mirror = 'tests/' + (path[len('src/'):] if path.startswith('src/') else path)
        if mirror not in have:
            missing.append(path)
    share = 100 * len(missing) // len(tracked('src/*.c', 'cli/*.c'))
    yield 'percent-of-sources-without-namesake', share, missing


# ---- numbers in the code ----

def constants(_):
    """Literals below 1e-3 or above 1e3 with a point or an exponent, no comment within the four lines above."""
    found = []
    literal = re.compile(r'(?<![\w.])(\d+\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)(?![\w.])')
    for path in tracked(*PRODUCT):
        text = read(path)
        if not literal.search(text):
            continue
        raw, bare = text.split('\n'), blanked(text).split('\n')
        commented = [a != b for a, b in zip(raw, blanked(text, ('comment',)).split('\n'))]
        for i, line in enumerate(bare):
            for match in literal.finditer(line):
                number = match.group(1)
                if '.' not in number and 'e' not in number.lower():
                    continue
                value = float(number)
                if (value == 0 or 1e-3 <= value <= 1e3) or any(commented[max(0, i - 4):i + 1]):
                    continue
                found.append(f'{path}:{i + 1}: {number}   {raw[i].strip()}')
    yield 'constants-unexplained', len(found), found


# ---- public functions ----

def public_functions():
    """(header, line, name, names of the parameters, doc block directly above or '', returns a status)."""
    for header in tracked('include/*.h'):
        text = read(header)
        bare = blanked(text)
        for match in re.finditer(r'BATTEN_API\b([^;{}]*?)\b(batten_\w+)\s*\(', bare):
            depth, i = 1, match.end()
            while depth:
                depth += {'(': 1, ')': -1}.get(bare[i], 0)
                i += 1
            parts, depth, begin = [], 0, match.end()
            for k in range(match.end(), i):
                c = bare[k]
                if k == i - 1 or (c == ',' and depth == 0):
                    parts.append(bare[begin:k].strip())
                    begin = k + 1
                depth += (c in '([') - (c in ')]')
            names = []
            for part in parts:
                if part in ('', 'void'):
                    continue
                call = re.search(r'\(\s*\*\s*(\w+)', part)
                names.append('...' if part == '...' else call.group(1) if call
                             else re.findall(r'\w+', re.sub(r'\[[^]]*\]', '', part))[-1])
            before = text[:match.start()].rstrip()
            block = before[before.rfind('/*'):] if before.endswith('*/') else ''
            yield (header, text.count('\n', 0, match.start()) + 1, match.group(2), names, block,
                   'batten_status' in match.group(1))


def interface(_):
    rows = list(public_functions())
    wide = sorted(((len(r[3]), f'{r[0]}:{r[1]}: {r[2]} takes {len(r[3])}') for r in rows if len(r[3]) > 6), reverse=True)
    yield 'public-parameters-over-6', len(wide), [t for _, t in wide]
    yield 'public-headers', len({r[0] for r in rows}), sorted({r[0] for r in rows})
    named = set(re.findall(r'<batten/(\w+\.h)>', read('include/batten/batten.h'))) | {'batten.h'}
    lost = [h for h in tracked('include/*.h') if h.split('/')[-1] not in named]
    yield 'headers-not-named-in-batten.h', len(lost), lost
    odd = [f'{r[0]}:{r[1]}: {r[2]}' for r in rows if re.search(r'_of_(curve|surface|chain|body|triangles|points|name)\b', r[2])]
    yield 'conversions-not-called-from', len(odd), odd


def options(_):
    """Every public function that takes a struct with a `size` has a row in some tests/.../options.c."""
    sized = set()
    for header in tracked('include/*.h'):
        for match in re.finditer(r'typedef struct \w*\s*\{([^{}]*)\}\s*(\w+);', blanked(read(header))):
            if re.search(r'\bsize_t size;', match.group(1)):
                sized.add(match.group(2))
    sized -= {'batten_job'}   # tests/base/work.c
    tested = set()
    for path in tracked('tests/*.c'):
        if path.endswith('/options.c'):
            tested |= set(re.findall(r'\bbatten_\w+', read(path)))
    bare = {header: blanked(read(header)) for header in tracked('include/*.h')}
    lost = []
    for header, line, name, *_ in public_functions():
        declaration = re.search(rf'\b{name}\s*\(([^;]*);', bare[header]).group(1)
        if sized & set(re.findall(r'(\w+) \*', declaration)) and name not in tested:
            lost.append(f'{header}:{line}: {name}')
    yield 'options-without-row', len(lost), lost


def blocks(_):
    rows = list(public_functions())
    bare = [f'{r[0]}:{r[1]}: {r[2]}' for r in rows if not r[4]]
    yield 'public-without-block', len(bare), bare
    unnamed = [f'{r[0]}:{r[1]}: {r[2]}: {p}' for r in rows if r[4] for p in r[3]
               if p != '...' and not re.search(rf'\b{re.escape(p)}\b', r[4])]
    yield 'public-parameters-unnamed', len(unnamed), unnamed
    mute = [f'{r[0]}:{r[1]}: {r[2]}' for r in rows if r[4] and r[5] and '@return' not in r[4]]
    yield 'public-status-untold', len(mute), mute
    costless = [f'{r[0]}:{r[1]}: {r[2]}' for r in rows if r[4] and r[5] and 'Cost:' not in r[4]]
    yield 'public-without-cost', len(costless), costless
    outside = []
    keys = set(re.findall(r'^@\w+\{([^,\s]+),', read('docs/bibliography.bib'), re.M))
    for path in tracked(*PRODUCT, 'include/*.h'):
        for i, line in enumerate(read(path).split('\n')):
            if re.search(r'\.\./shared|\b[\w-]+\.md\b(?! of docs)', line) and 'docs/' not in line:
                outside.append(f'{path}:{i + 1}: {line.strip()}')
            for key in re.findall(r'Source: \[([\w+-]+)\]', line):
                if key not in keys:
                    outside.append(f'{path}:{i + 1}: [{key}] is not in docs/bibliography.bib')
    yield 'pointers-outside', len(outside), outside


# ---- functions ----

def functions(_):
    needs('ctags', 'universal-ctags')
    sources = tracked(*PRODUCT)
    done = subprocess.run(['ctags', '--c-kinds=f', '--fields=+neS', '--output-format=json', '-f', '-', '-L', '-'],
                          input='\n'.join(sources), cwd=ROOT, capture_output=True, text=True)
    if done.returncode != 0:
        raise Skip('this ctags does not write JSON (package universal-ctags)')
    text = {p: blanked(read(p)).split('\n') for p in sources}
    sizes, wide, deep, vague = [], [], [], []
    for line in done.stdout.splitlines():
        tag = json.loads(line)
        if 'end' not in tag:
            continue
        at = f"{tag['path']}:{tag['line']}: {tag['name']}"
        body = [x for x in text[tag['path']][tag['line'] - 1:tag['end']] if x.strip()]
        sizes.append((len(body), at))
        inner = tag.get('signature', '()')[1:-1]
        depth, count = 0, 0 if inner.strip() in ('', 'void') else 1
        for c in inner:
            depth += (c == '(') - (c == ')')
            count += c == ',' and depth == 0
        wide.append((count, at))
        depth = most = 0
        for c in ''.join(body):
            depth += (c == '{') - (c == '}')
            most = max(most, depth)
        deep.append((most, at))
        if tag['name'] in VAGUE and 'file' in tag:
            vague.append(at)
    sizes.sort(reverse=True)
    wide.sort(reverse=True)
    deep.sort(reverse=True)
    ordered = sorted(n for n, _ in sizes)
    shown = [f'{at}: {n} lines' for n, at in sizes[:15]]
    yield 'function-lines-median', int(statistics.median(ordered)), shown
    yield 'function-lines-p90', ordered[int(0.9 * len(ordered))], shown
    yield 'function-lines-max', ordered[-1], shown
    yield 'parameters-over-8', sum(n > 8 for n, _ in wide), [f'{at}: {n} parameters' for n, at in wide if n > 8]
    counts = sorted(n for n, _ in wide)
    yield 'parameters-p95', counts[int(0.95 * len(counts))], [f'{at}: {n} parameters' for n, at in wide[:20]]
    yield 'nesting-max', deep[0][0], [f'{at}: {n} deep' for n, at in deep[:10]]
    yield 'statics-vague', len(vague), vague


# ---- who uses whom, from the objects ----

def symbols(build):
    """source -> names defined for others, source -> names wanted."""
    needs('nm', 'binutils')
    objects = {}
    # Not below: the test of an installation keeps a build of its own in there.
    places = (os.path.join(build, folder, 'CMakeFiles') for folder in ('', 'cli'))
    for base, _, names in (step for place in places for step in os.walk(place)):
        for name in names:
            match = re.search(r'/(batten(?:-\w+)?-objects|batten-command)\.dir/(.*\.c)\.o$', os.path.join(base, name))
            if match:
                source = match.group(2) if match.group(1) != 'batten-command' else 'cli/' + match.group(2)
                if os.path.exists(os.path.join(ROOT, source)):
                    objects[os.path.join(base, name)] = source
    if not objects:
        raise Skip(f'there are no objects in {build}')
    defined, wanted = collections.defaultdict(set), collections.defaultdict(set)
    for line in subprocess.check_output(['nm', '-A', *objects], text=True).splitlines():
        path, rest = line.split(':', 1)
        kind, name = rest.split()[-2:]
        if not name.startswith(('bat_', 'batten_')):
            continue
        if kind in 'TDBR':
            defined[objects[path]].add(name)
        elif kind == 'U':
            wanted[objects[path]].add(name)
    return defined, wanted


def circles_of(arrows):
    """Groups of nodes that reach each other (Tarjan)."""
    index, low, stack, waiting, groups = {}, {}, [], set(), []
    sys.setrecursionlimit(100000)

    def visit(node):
        index[node] = low[node] = len(index)
        stack.append(node)
        waiting.add(node)
        for other in sorted(arrows.get(node, ())):
            if other not in index:
                visit(other)
                low[node] = min(low[node], low[other])
            elif other in waiting:
                low[node] = min(low[node], index[other])
        if low[node] == index[node]:
            group = []
            while not group or group[-1] != node:
                group.append(stack.pop())
                waiting.discard(group[-1])
            if len(group) > 1:
                groups.append(sorted(group))

    for node in sorted(arrows):
        if node not in index:
            visit(node)
    return sorted(groups, key=len, reverse=True)


def circles(build):
    defined, wanted = symbols(build)
    home = {name: source for source, names in defined.items() for name in names}
    arrows = {s: {home[n] for n in names if n in home and home[n] != s} for s, names in wanted.items()}
    groups = circles_of(arrows)
    yield 'circles-of-files', len(groups), [f'{len(g)}: {" ".join(g)}' for g in groups]
    rooms = collections.defaultdict(set)
    for source, others in arrows.items():
        rooms[os.path.dirname(source)] |= {os.path.dirname(o) for o in others} - {os.path.dirname(source)}
    # A folder and those in it are one room: parts may be used from above and use what lies beside it.
    groups = circles_of(rooms)
    yield 'circles-of-rooms', len(groups), [f'{len(g)}: {" ".join(g)}' for g in groups]
    users = collections.defaultdict(set)
    for source, names in wanted.items():
        for name in names:
            users[name].add(source)
    alone = sorted(f'{home[n]}: {n}' for n in home if n.startswith('bat_') and not users[n])
    yield 'shared-names-used-in-one-file', len(alone), alone


GUARDS = {'files': files, 'openings': openings, 'namesakes': named_tests, 'constants': constants,
          'interface': interface, 'options': options, 'blocks': blocks, 'functions': functions, 'circles': circles}


# ---- budgets ----

def parsed(text):
    """name -> budget."""
    rows = (line.split('#')[0].split() for line in text.split('\n'))
    return {row[0]: int(row[1]) for row in rows if row}


def rise():
    """No commit raised a budget."""
    def git(*words):
        return subprocess.run(['git', '-C', ROOT, *words], capture_output=True, text=True)
    log = git('log', '--format=%h', '-100', '--', BUDGETS)
    if log.returncode != 0:
        raise Skip('there is no history')
    versions = [('the working tree', read(BUDGETS))]
    for commit in log.stdout.split():
        then = git('show', f'{commit}:{BUDGETS}')
        if then.returncode == 0:
            versions.append((commit, then.stdout))
    bad = []
    for (name, new), (_, old) in zip(versions, versions[1:]):
        now, was = parsed(new), parsed(old)
        bad += [f'{name}: {key} raised from {was[key]} to {now[key]}' for key in now if key in was and now[key] > was[key]]
    for line in bad:
        print(line)
    return 1 if bad else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('guards', nargs='*', metavar='GUARD', help=' '.join(GUARDS))
    parser.add_argument('--build', default=os.path.join(ROOT, 'build', 'test'))
    parser.add_argument('--list', action='store_true')
    parser.add_argument('--rise', action='store_true')
    options = parser.parse_args()
    if options.rise:
        return rise()
    unknown = [name for name in options.guards if name not in GUARDS]
    if unknown:
        parser.error(f'unknown guard {unknown[0]!r}: choose from ' + ', '.join(GUARDS))
    budgets, bad = parsed(read(BUDGETS)), 0
    for name in options.guards or GUARDS:
        for figure, value, lines in GUARDS[name](options.build):
            budget = budgets.get(figure)
            if budget is None:
                print(f'{figure} {value}: no budget in {BUDGETS}')
                bad += 1
            elif value > budget:
                print(f'{figure}: {value}, the budget is {budget}')
                bad += 1
            elif value < budget:
                print(f'{figure}: {value}; the budget in {BUDGETS} can be lowered from {budget}')
            else:
                print(f'{figure}: {value}')
            if options.list or budget is None or value > budget:
                print('\n'.join(f'  {line}' for line in lines[:1000 if options.list else 60]))
    return bad != 0


if __name__ == '__main__':
    try:
        sys.exit(main())
    except Skip as why:
        print(f'skipped: {why}')
        sys.exit(77)
