#!/usr/bin/env python3
"""Random mutants: is a mistake in the code noticed by the tests of its room?

One place of one source file is changed, the file is compiled, the test program of the folder is linked anew
with that one object, and the tests of the room run. A mutant that no test notices survives and is printed.
A room is a folder with sources: shape/skin is src/shape/skin, tested by tests/shape/skin alone.

Nothing in the tree is touched: the objects of the build are copied first, mutants live in a temporary folder.
A mutant may write anywhere: one started by root runs as nobody, who cannot replace what is not its own.
A mutant that does not compile, or whose object code is that of the original, is drawn again. A test run that
takes many times as long as usual has noticed its mutant. What the tests do not notice they may still notice with
failing allocations, as CI runs them: a sample of these is tried then. Times are those of the processor, so that
what runs beside the trial does not change its outcome.
"""
import argparse
import collections
import concurrent.futures
import json
import math
import os
import random
import re
import resource
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
import threading
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from source import ROOT, TOKENS, blanked, read, tracked, without_directives  # noqa: E402

FAULT_SECONDS, FAULT_LIMIT = '0.02', 90  # of the processor: for each test, for those of a room
BESIDE = 12  # a run that has not ended after so many times its limit hangs, whatever else the machine does
NOBODY = 65534  # its number on every system that we know
KERNEL = ['base', 'numeric', 'spline', 'inspect', 'shape', 'body', 'mesh', 'model', 'fair', 'loft', 'hydrostatics', 'exchange']
NEGATED = {'<': '>=', '<=': '>', '>': '<=', '>=': '<', '==': '!=', '!=': '=='}
WIDENED = {'<': '<=', '<=': '<', '>': '>=', '>=': '>'}
SWAPPED = {'+': '-', '-': '+', '*': '/', '/': '*', '+=': '-=', '-=': '+=', '*=': '/=', '/=': '*='}
NO_TYPES = {'return', 'case', 'sizeof', 'else', 'goto'}
RETURNED = {'true': 'false', 'false': 'true', 'status': 'BATTEN_OK', 'BATTEN_OK': 'BATTEN_OUT_OF_MEMORY'}


# ---- places that can be changed ----

def room_of(path):
    folder = os.path.dirname(path)
    return folder[len('src/'):] if folder.startswith('src/') else folder


def tokens_of(text):
    bare = without_directives(blanked(text))
    return bare, [m for m in TOKENS.finditer(bare)]


def matching(tokens, i):
    """The index of the token that closes the bracket at i."""
    close, depth = {'(': ')', '[': ']', '{': '}'}[tokens[i].group()], 0
    for j in range(i, len(tokens)):
        depth += (tokens[j].group() == tokens[i].group()) - (tokens[j].group() == close)
        if depth == 0:
            return j
    return len(tokens) - 1


def depths(tokens):
    """Depth in braces of each token, and whether it stands in a function: where a `{` follows a `)`."""
    inside, result, stack = 0, [], []
    for i, token in enumerate(tokens):
        t = token.group()
        if t == '{':
            stack.append(bool(inside) or (i > 0 and tokens[i - 1].group() == ')'))
            inside = stack[-1]
        result.append(bool(inside))
        if t == '}' and stack:
            stack.pop()
            inside = stack[-1] if stack else False
    return result


def array_sizes(tokens):
    """The indices of tokens in the sizes of arrays that are declared: `double row[3]`, `bat_row at[2][MOST + 1]`."""
    found = set()
    for i, token in enumerate(tokens):
        if token.group() != '[' or i == 0 or not re.fullmatch(r'\w+', tokens[i - 1].group()):
            continue
        kind = tokens[i - 2] if i > 1 else None
        if kind is None or not re.fullmatch(r'[A-Za-z_]\w*', kind.group()) or kind.group() in NO_TYPES:
            continue
        while i < len(tokens) and tokens[i].group() == '[':
            close = matching(tokens, i)
            found.update(range(i + 1, close))
            i = close + 1
    return found


def places(text):
    """All changes that can be made: kind -> [(from, to, replacement)]."""
    bare, tokens = tokens_of(text)
    function = depths(tokens)
    sizes = array_sizes(tokens)  # room that nobody uses is nothing that a test could notice
    found = collections.defaultdict(list)
    skip_until = -1
    for i, token in enumerate(tokens):
        t, a, b = token.group(), token.start(), token.end()
        if t in ('assert', 'static_assert', '_Static_assert') and i + 1 < len(tokens):
            skip_until = max(skip_until, matching(tokens, i + 1))
        if i <= skip_until:
            continue
        before = tokens[i - 1].group() if i else ''
        after = tokens[i + 1].group() if i + 1 < len(tokens) else ''
        spaced = bare[a - 1:a].isspace() and bare[b:b + 1].isspace()
        if token.lastgroup == 'number' and not (before == '[' and not function[i]) and i not in sizes:
            found['constant'].append((a, b, f'({t} + 1)'))
        if not function[i]:
            continue
        if t in NEGATED and spaced and not (before == 'status' and after == 'BATTEN_OK'):
            found['comparison'].append((a, b, NEGATED[t]))
            if t in WIDENED:
                found['off by one'].append((a, b, WIDENED[t]))
        elif t in SWAPPED and spaced and (before[-1:].isalnum() or before in (')', ']', '_')):
            found['arithmetic'].append((a, b, SWAPPED[t]))
        elif t in ('&&', '||'):
            found['logic'].append((a, b, '||' if t == '&&' else '&&'))
        elif t == 'if' and after == '(':
            open_, close = tokens[i + 1].end(), tokens[matching(tokens, i + 1)].start()
            if not re.fullmatch(r'\s*status [!=]= BATTEN_OK\s*', bare[open_:close]):
                found['condition'].append((open_, close, f'!({text[open_:close]})'))
        elif t == '[' and re.fullmatch(r'\w+', before) and i + 2 < len(tokens) and tokens[i + 2].group() == ']' \
                and tokens[i + 1].lastgroup == 'name' and i + 1 not in sizes:
            found['off by one'].append((b, b + len(after), f'{after} + 1'))
        elif t == 'return' and i + 2 < len(tokens) and tokens[i + 2].group() == ';' and after in RETURNED:
            found['return'].append((tokens[i + 1].start(), tokens[i + 1].end(), RETURNED[after]))
        elif t.startswith('BATTEN_') and before == '(' and i > 1 and tokens[i - 2].group().startswith('bat_fail'):
            other = 'BATTEN_UNSUPPORTED' if t != 'BATTEN_UNSUPPORTED' else 'BATTEN_OUT_OF_MEMORY'
            found['return'].append((a, b, other))
        if before in (';', '{', '}', ')', 'else') and token.lastgroup == 'name' and is_statement(tokens, i):
            end = next(j for j in range(i, len(tokens)) if tokens[j].group() == ';')
            found['dropped'].append((a, tokens[end].end(), '(void)0;' + '\n' * text.count('\n', a, tokens[end].end())))
    return found


KEYWORDS = {'return', 'break', 'continue', 'goto', 'case', 'default', 'if', 'for', 'while', 'do', 'switch', 'else',
            'static', 'const', 'typedef', 'extern', 'struct', 'enum', 'union', 'sizeof', 'assert', 'static_assert'}


def is_statement(tokens, i):
    """An assignment or a call on its own, which begins with the name at i."""
    if tokens[i].group() in KEYWORDS:
        return False
    j = i + 1
    while j < len(tokens):
        t = tokens[j].group()
        if t in ('[', '('):
            close = matching(tokens, j)
            if t == '(':
                return close + 1 < len(tokens) and tokens[close + 1].group() == ';'
            j = close + 1
        elif t in ('.', '->'):
            j += 2
        else:
            return t in ('=', '+=', '-=', '*=', '/=', '|=', '&=', '++', '--')
    return False


def draw(texts, weights, spots, generator):
    """A mutant: (path, from, to, replacement, kind)."""
    while True:
        path = generator.choices(list(texts), weights)[0]
        if path not in spots:
            spots[path] = places(texts[path])
        kinds = sorted(spots[path])
        if not kinds:
            if not any(spots.get(p) is None or spots[p] for p in texts):
                return None
            continue
        kind = generator.choice(kinds)
        return (path, *generator.choice(spots[path][kind]), kind)


# ---- compiling, linking, running ----

def command_lines(build):
    """Source -> (words of its compilation, without output, debugging and -Werror; folder of the compiler)."""
    rules = json.loads(subprocess.check_output(['ninja', '-C', build, '-t', 'compdb'], text=True))
    found = {}
    for rule in rules:
        source = os.path.relpath(os.path.join(rule['directory'], rule['file']), ROOT)
        if not rule.get('output', '').endswith('.o') or '/fuzz/' in rule['output']:
            continue
        words, kept, i = shlex.split(rule['command']), [], 0
        while i < len(words):
            w = words[i]
            if w in ('-o', '-MF', '-MT', '-MQ'):
                i += 2
                continue
            if w not in ('-c', '-g', '-MD', '-Werror') and w != rule['file'] and not w.endswith('ccache'):
                kept.append(w)
            i += 1
        found.setdefault(source, (kept, os.path.join(build, rule['output'])))
    return found


class Workshop:
    """Copies of the objects, made once, and what compiles, links and runs a mutant."""

    def __init__(self, build, folder):
        self.build, self.folder, self.lock = build, folder, threading.RLock()
        self.lines, self.programs, self.originals = command_lines(build), {}, {}
        self.times, self.fault_times = {}, {}
        self.linker = '-fuse-ld=lld' if shutil.which('ld.lld') else '-fno-lto'
        self.compiler = next(iter(self.lines.values()))[0][0]
        libraries = subprocess.run(['pkg-config', '--libs', 'cmocka', 'cairo', 'yaml-0.1'], capture_output=True,
                                   text=True).stdout.split()
        self.libraries = libraries + ['-lm', '-lpthread']

    def archive(self, name, sources):
        path = os.path.join(self.folder, f'lib{name}.a')
        if not os.path.exists(path):
            objects = [self.lines[s][1] for s in sources if s in self.lines]
            with open(path + '.names', 'w') as file:
                file.write('\n'.join(objects))
            subprocess.check_call(['ar', 'qcS', path, f'@{path}.names'])
            subprocess.check_call(['strip', '-g', path])
            subprocess.check_call(['ranlib', path])
        return path

    def tests(self, top):
        """The objects of one test program as one object, and the archive of all that it tests."""
        with self.lock:
            if top in self.programs:
                return self.programs[top]
            sources = [s for s in self.lines if s.startswith((f'tests/{top}/', 'tests/support/'))]
            path = os.path.join(self.folder, f'tests-{top}.o')
            rules = json.loads(subprocess.check_output(['ninja', '-C', self.build, '-t', 'compdb'], text=True))
            objects = sorted({os.path.join(self.build, r['output']) for r in rules
                              if r.get('output', '').endswith('.o') and
                              any(f'batten-test-{part}.dir/' in r['output'] for part in (top, 'kit'))})
            if not objects or not sources:
                self.programs[top] = None
                return None
            subprocess.check_call(['ld', '-r', '--strip-debug', '-o', path, *objects])
            built = [s for s in self.lines if s.startswith('src/') and os.path.exists(self.lines[s][1])]
            archives = [self.archive('kernel', built)]
            self.programs[top] = (path, archives)
            return self.programs[top]

    def compile(self, path, text, at):
        """The object made of this text, or None."""
        source, target = os.path.join(at, os.path.basename(path)), os.path.join(at, 'one.o')
        with open(source, 'w', encoding='utf-8') as file:
            file.write(text)
        words = self.lines[path][0]
        done = subprocess.run([*words, '-g0', '-w', '-iquote', os.path.dirname(os.path.join(ROOT, path)), '-c',
                               source, '-o', target], cwd=at, capture_output=True)
        return target if done.returncode == 0 else None

    def link(self, words, target):
        done = subprocess.run([self.compiler, self.linker, '-o', target, *words, *self.libraries],
                              capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f'a test program does not link:\n{done.stderr[-3000:]}')

    def program(self, path, made, at):
        """(The test program, the command) with this object in place of the original."""
        top = room_of(path).split('/')[0]
        tests, archives = self.tests(top)
        target, command = os.path.join(at, 'tests'), None
        own = [made] if path.startswith('src/') else []
        self.link([tests, *own, *archives], target)
        if top in ('cli', 'design'):
            command = os.path.join(at, 'batten')
            main = [self.lines[s][1] for s in self.lines if s.startswith('cli/') and s != path]
            self.link(['-Wl,-S', *main, made, *archives], command)
        return target, command

    def run(self, target, command, room, at, limit, faults=False):
        """(Do the tests of the room notice, seconds of the processor). Stops at the first that does."""
        scratch = os.path.join(at, 'scratch')
        os.makedirs(scratch, exist_ok=True)
        if os.geteuid() == 0:
            os.chmod(at, 0o755)
            os.chmod(scratch, 0o777)
        environment = dict(os.environ, TMPDIR=scratch, BATTEN_FAULT_SECONDS=FAULT_SECONDS,
                           **({'BATTEN_COMMAND': command} if command else {}))

        def limits():
            os.setsid()
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            resource.setrlimit(resource.RLIMIT_CPU, (math.ceil(limit), math.ceil(limit) + 1))
            resource.setrlimit(resource.RLIMIT_AS, (6 << 30, 6 << 30))
            resource.setrlimit(resource.RLIMIT_FSIZE, (1 << 28, 1 << 28))
            if os.geteuid() == 0:
                os.setgroups([])
                os.setgid(NOBODY)
                os.setuid(NOBODY)

        words = [target, '--room', room, *(['--faults'] if faults else [])]
        process = subprocess.Popen(words, cwd=scratch, env=environment, preexec_fn=limits,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        timer = threading.Timer(BESIDE * limit, lambda: end(process))
        timer.start()
        noticed = False
        for line in process.stderr:
            if b'[  FAILED  ]' in line:
                noticed = True
                break
        if noticed:
            end(process)
        status, used = os.wait4(process.pid, 0)[1:]
        process.returncode = os.waitstatus_to_exitcode(status)
        timer.cancel()
        process.stderr.close()
        shutil.rmtree(scratch, ignore_errors=True)
        return noticed or process.returncode != 0, used.ru_utime + used.ru_stime


def end(process):
    """The process and its children."""
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass


def tests_of(room):
    """The room whose tests stand for this one: its own, or the nearest above that has some."""
    while room:
        folder = os.path.join(ROOT, 'tests', room)
        if os.path.isdir(folder) and any(n.endswith('.c') for n in os.listdir(folder)):
            return room
        room = os.path.dirname(room)
    return None


# ---- the trial ----

def one(workshop, texts, weights, spots, seed, room, at):
    """Draws until a mutant compiles to other code; (mutant, line, was it noticed, seconds)."""
    generator = random.Random(seed)
    for _ in range(200):
        mutant = draw(texts, weights, spots, generator)
        if not mutant:
            return None
        path, a, b, replacement, kind = mutant
        text = texts[path]
        with workshop.lock:
            original = workshop.originals.get(path)
        if original is None:
            made = workshop.compile(path, text, at)
            original = compared(made) if made else b''
            with workshop.lock:
                workshop.originals[path] = original
        made = workshop.compile(path, text[:a] + replacement + text[b:], at)
        if not made or not original or compared(made) == original:
            continue
        begin = time.monotonic()
        target, command = workshop.program(path, made, at)
        noticed = workshop.run(target, command, room, at, 5 * workshop.times[room] + 5)[0]
        if not noticed and stands_faults(workshop, room):
            noticed = workshop.run(target, command, room, at, 2 * workshop.fault_times[room] + 5, faults=True)[0]
        return mutant, noticed, time.monotonic() - begin
    return None


def compared(path):
    """The object without its symbol table, which names the temporary file."""
    bare = path + '.bare'
    subprocess.check_call(['objcopy', '--remove-section=.comment', '--strip-unneeded', path, bare])
    with open(bare, 'rb') as file:
        return file.read()


def run_as_is(workshop, room, limit, faults=False):
    """Run the room without a mutant: how long it takes, and whether it passes."""
    top = room.split('/')[0]
    tests, archives = workshop.tests(top)
    with tempfile.TemporaryDirectory(dir=workshop.folder) as at:
        target = os.path.join(at, 'tests')
        workshop.link([tests, *archives], target)
        command = None
        if top in ('cli', 'design'):
            command = os.path.join(at, 'batten')
            main = [line[1] for s, line in workshop.lines.items() if s.startswith('cli/')]
            workshop.link(['-Wl,-S', *main, *archives], command)
        failed, seconds = workshop.run(target, command, room, at, limit, faults)
        return seconds, not failed


def measure(workshop, room):
    workshop.times[room], passes = run_as_is(workshop, room, 600)
    if not passes:
        sys.exit(f'the tests of {room} fail as they are')


def stands_faults(workshop, room):
    """Whether failing allocations can tell about mutants of this room; tests of the command run it beside them."""
    if room.startswith('cli'):
        return False
    with workshop.lock:
        if room not in workshop.fault_times:
            seconds, passes = run_as_is(workshop, room, FAULT_LIMIT, faults=True)
            workshop.fault_times[room] = seconds if passes else None
            if not passes:
                print(f'{room}: its tests with failing allocations take longer than {FAULT_LIMIT} s, or fail')
    return workshop.fault_times[room] is not None


def shown(mutant, texts):
    path, a, b, replacement, kind = mutant
    text = texts[path]
    line = text.count('\n', 0, a) + 1
    begin, finish = text.rfind('\n', 0, a) + 1, text.find('\n', b)
    was = ' '.join(text[begin:finish].split())
    new = ' '.join((text[begin:a] + replacement + text[b:finish]).split())
    return f'{path}:{line}: {kind}\n    - {was}\n    + {new}'


def rooms_and_files():
    rooms = collections.defaultdict(list)
    for path in tracked('src/*.c', 'cli/*.c'):
        rooms[room_of(path)].append(path)
    return rooms


def shares(rooms, total):
    """How many mutants of the total each room gets: by its lines, by largest remainders."""
    lines = {r: sum(read(p).count('\n') for p in files) for r, files in rooms.items()}
    whole = sum(lines.values())
    exact = {r: total * n / whole for r, n in lines.items()}
    counts = {r: int(x) for r, x in exact.items()}
    for r in sorted(exact, key=lambda r: counts[r] - exact[r])[:total - sum(counts.values())]:
        counts[r] += 1
    return {r: n for r, n in counts.items() if n}


def chosen(rooms, names):
    found = {}
    for name in names:
        name = name.strip('/')
        name = name[len('src/'):] if name.startswith('src/') else name
        fit = [r for r in rooms if r == name or r.startswith(name + '/')]
        if not fit:
            sys.exit(f'there is no room {name}; rooms: {" ".join(sorted(rooms))}')
        found.update(dict.fromkeys(sorted(fit)))
    return list(found)


def bring_up_to_date(build, rooms):
    """Configure and compile what the test programs of these rooms are made of."""
    if not os.path.exists(os.path.join(build, 'build.ninja')):
        subprocess.check_call(['cmake', '--preset', os.path.basename(build)], cwd=ROOT, stdout=subprocess.DEVNULL)
    tops = {room.split('/')[0] for room in rooms}
    targets = [f'batten-test-{top}' for top in sorted(tops)] + (['batten-command'] if tops & {'cli', 'design'} else [])
    done = subprocess.run(['cmake', '--build', build, '--target', *targets], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f'the build fails:\n{done.stdout[-3000:]}')


def main():
    parser = argparse.ArgumentParser(prog='./dev mutants', description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('--room', action='append', metavar='shape/skin',
                        help='this room and those in it; may be repeated; without it: every room')
    parser.add_argument('--file', action='append', metavar='PATH', help='mutants in these files alone')
    parser.add_argument('--count', type=int, default=10, help='mutants for each room (10)')
    parser.add_argument('--all', type=int, metavar='N', help='N mutants over all rooms, in proportion to their lines')
    parser.add_argument('--seed', type=int, default=1, help='the same seed and sources draw the same mutants (1)')
    parser.add_argument('--jobs', type=int, default=os.cpu_count(), help='how many at once')
    parser.add_argument('--build', default=os.path.join(ROOT, 'build', 'test'), help='a build whose objects are used')
    parser.add_argument('--least', type=float, default=0, metavar='PERCENT', help='fail when fewer are noticed over all')
    parser.add_argument('--verbose', action='store_true', help='print the mutants that are noticed, too')
    options = parser.parse_args()

    rooms = rooms_and_files()
    if options.all:
        counts = shares(rooms, options.all)
    else:
        counts = dict.fromkeys(chosen(rooms, options.room) if options.room else sorted(rooms), options.count)
    if options.file:
        files = {os.path.relpath(os.path.abspath(f), ROOT) for f in options.file}
        rooms = {r: [p for p in paths if p in files] for r, paths in rooms.items()}
        counts = {r: options.count for r in rooms if rooms[r]}

    bring_up_to_date(options.build, counts)
    holder = os.path.join(ROOT, 'build')
    os.makedirs(holder, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix='mutants-', dir=holder) as folder:
        if os.geteuid() == 0:
            os.chmod(folder, 0o755)
        trial(options, rooms, counts, Workshop(options.build, folder), folder)


def trial(options, rooms, counts, workshop, folder):
    tally, survivors = collections.OrderedDict(), 0
    pool = concurrent.futures.ThreadPoolExecutor(options.jobs)
    for room, count in sorted(counts.items()):
        testing = tests_of(room)
        if not testing:
            print(f'{room}: no tests')
            tally[room] = (0, count)
            continue
        if testing not in workshop.times:
            measure(workshop, testing)
        texts = {p: read(p) for p in rooms[room]}
        weights, spots = [texts[p].count('\n') for p in texts], {}

        def work(i, room=room, testing=testing, texts=texts, weights=weights, spots=spots):
            with tempfile.TemporaryDirectory(dir=folder) as at:
                return one(workshop, texts, weights, spots, f'{options.seed} {room} {i}', testing, at)

        noticed = drawn = 0
        for result in pool.map(work, range(count)):
            if not result:
                continue
            mutant, seen, seconds = result
            drawn, noticed = drawn + 1, noticed + seen
            if not seen or options.verbose:
                print(f'{"noticed" if seen else "SURVIVES"} {shown(mutant, texts)}', flush=True)
        tally[room] = (noticed, drawn)
        by = '' if testing == room else f', by the tests of {testing}: it has none of its own'
        print(f'{room}: {noticed} of {drawn} noticed{by}; its tests take {workshop.times[testing]:.1f} s', flush=True)
    noticed, drawn = sum(a for a, _ in tally.values()), sum(b for _, b in tally.values())
    if len(tally) > 1:
        print('\npercent noticed, by rooms')
        for room, (a, b) in sorted(tally.items(), key=lambda row: row[1][0] / max(1, row[1][1])):
            print(f'  {100 * a / max(1, b):5.1f}  {a:4} of {b:<4} {room}')
    share = 100 * noticed / max(1, drawn)
    print(f'{share:.1f} % noticed: {noticed} of {drawn} mutants, seed {options.seed}')
    sys.exit(share < options.least)


if __name__ == '__main__':
    main()
