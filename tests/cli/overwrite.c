#include "support/process.h"

#include <stdio.h>

/* Under its own name, by a symbolic link, by a hard link. */
TEST(the_file_that_is_read_is_not_overwritten)
{
    static const char *const lines[] = {
        "\"$BATTEN\" convert own.svg own.svg",
        "ln -sf own.svg soft.svg; \"$BATTEN\" convert own.svg -o ./soft.svg",
        "ln -f own.svg hard.svg; \"$BATTEN\" convert own.svg#line hard.svg",
        "\"$BATTEN\" convert - own.svg < own.svg",
        "\"$BATTEN\" draw own.svg -o own.svg",
        "cp own.svg own.xyz; \"$BATTEN\" fit own.xyz -o own.xyz",
        "cp own.svg own.xyz; \"$BATTEN\" fair own.xyz -o own.xyz --within 1",
        "\"$BATTEN\" compare own.svg -o own.svg",
    };
    const char *path = test_scratch("own.svg");
    test_write(path, "<svg xmlns=\"http://www.w3.org/2000/svg\">"
                     "<path id=\"line\" d=\"M0 0L1 1\"/></svg>\n");
    for (int i = 0; i < COUNT(lines); i++) {
        char line[1024];
        snprintf(line, sizeof line, "cd \"$(dirname '%s')\" && %s", path, lines[i]);
        const test_process run = test_shell(line);
        CHECK_INT(run.exit, 2);
        CHECK_CONTAINS(run.errors, "is the file that is read, and would be overwritten");
        CHECK_CONTAINS(test_content(path), "M0 0L1 1");
    }
    CHECK_INT(RUN("batten", "convert", path, test_scratch("other.svg")).exit, 0);
}

static const char design[] = "batten: 1\nunits: mm\nfeatures:\n  a: {read: points.csv}\n"
                             "  b: {read: part/more.csv}\n  c: {interpolate: a}\n"
                             "outputs:\n  points.csv: a\n  more.csv: b\n";

/* The design and what it reads, under their own names and through links; nothing is made. */
TEST(build_does_not_overwrite_what_it_reads)
{
    static const char *const lines[][2] = {
        {"build own.yaml", "own.yaml"},
        {"build own.yaml -o .", "own.yaml"},
        {"build reads.yaml", "points.csv"},
        {"build ./reads.yaml -o ../overwrite", "points.csv"},
        {"build reads.yaml -o part", "more.csv"},
        {"build reads.yaml -o linked", "more.csv"},
        {"build reads.yaml --set features.b.read=points.csv -o soft", "more.csv"},
    };
    static const char prepare[] =
        "rm -rf overwrite; mkdir overwrite && cd overwrite && mkdir part soft && "
        "printf '0,0\\n1,1\\n2,0\\n' | tee points.csv > part/more.csv && "
        "ln -s part linked && ln -s ../points.csv soft/more.csv && "
        "printf 'batten: 1\\nfeatures:\\n  a: {line: [[0, 0], [1, 1]]}\\n"
        "outputs:\\n  other.igs: a\\n  \"own.yaml\": {check: a}\\n' > own.yaml && ";
    const char *reads = test_scratch("reads.yaml");
    test_write(reads, design);
    for (int i = 0; i < COUNT(lines); i++) {
        char line[2048], said[200];
        snprintf(line, sizeof line,
                 "cd \"$(dirname '%s')\" && %s cp ../reads.yaml . && find . | xargs ls -dl > "
                 "../before; \"$BATTEN\" %s; a=$?; find . | xargs ls -dl | cmp - ../before && "
                 "exit $a",
                 reads, prepare, lines[i][0]);
        snprintf(said, sizeof said, "%s' is the file that is read, and would be overwritten",
                 lines[i][1]);
        const test_process run = test_shell(line);
        CHECK_INT(run.exit, 2);
        CHECK_CONTAINS(run.errors, said);
        CHECK_TEXT(run.out, "");
    }
}
