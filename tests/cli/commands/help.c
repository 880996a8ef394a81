#include "cli/lines.h"

/* Topics of help, the manual page and completion. */

static const line_row topics[] = {
    {"$BATTEN help", 0,
     "usage: batten COMMAND ...|  build         make everything that a design file describes|Exit status: 0 done, 1 failed",
     ""},
    {"$BATTEN help build", 0,
     "usage: batten build DESIGN|\nOptions:\n  --output DIR, -o          where the outputs go (beside the design)|\n  --set NAME=VALUE          set a parameter of the design, or a value by its path (may be repeated)\n|\n  --json                    print the report as JSON\n|\n  --quiet, -q               no progress",
     ""},
    {"$BATTEN help draw", 0,
     "usage: batten draw IN -o PICTURE|Options:\n  --output PICTURE, -o      the file to write",
     ""},
    {"$BATTEN help fair", 0,
     "---- the feature of the same name ----\n\nfair: |\nParameters:\n|a feature|, required\n|In C: batten_fair_points|\nExample:\n\n",
     ""},
    {"$BATTEN help line", 0,
     "line: The straight line between two points\n|  line           a point, or several, required\n                 both ends\n",
     ""},
    {"$BATTEN help circle", 0,
     "  form           a word: square-9 triangle-7 square-7 (square-9)\n|Sources:|Les Piegl and Wayne Tiller, The NURBS Book",
     "!usage"},
    {"$BATTEN help bspline", 0, "b-spline: ", ""},
    {"$BATTEN help features", 0,
     "Operations of a design file:\n\n|\nOutputs of a design file:\n\n|\n  circle |\n  check ",
     ""},
    {"$BATTEN help design", 0, "A design file says how shapes come to be", ""},
    {"test \"$($BATTEN help units)\" = \"$($BATTEN help design)\" && test \"$($BATTEN help tolerance)\" = \"$($BATTEN help design)\"",
     0, "", ""},
    {"test \"$($BATTEN help offsets)\" = \"$($BATTEN help files)\"", 0, "", ""},
    {"$BATTEN help files", 0, "Files that Batten reads, told apart by their content", ""},
    {"$BATTEN help formats", 0,
     "Formats of files:\n\n  name      endings                  read write  what is kept\n|  step      .stp .step|\n  stl       .stl                     yes  yes    triangles alone, no unit",
     ""},
    {"$BATTEN help cricle", 2, "",
     "batten help: there is no topic 'cricle'; did you mean 'circle'; see"},
    {"$BATTEN help zzzzzzzzzz", 2, "", "there is no topic 'zzzzzzzzzz'; see 'batten help'"},
    {"$BATTEN help --as nothing", 2, "",
     "--as knows man, man-design, completion, literature and schema, not 'nothing'"},
    {"$BATTEN help --as schema > s.json && head -c 1 s.json", 0, "{", ""},
    {"$BATTEN help --as man", 0,
     ".TH BATTEN 1 |.SH NAME\nbatten \\- from points|.SS \"batten build DESIGN|.B \\-\\-output, \\-o DIR\n|.B \\-\\-json\nprint|.SH EXIT STATUS\n.TP\n.B \"0\"\ndone\n",
     ""},
    {"$BATTEN help --as man-design", 0,
     ".TH BATTEN\\-DESIGN 5 |.SH OPERATIONS\n|.SS circle\n|.SH OUTPUTS\n|.B \"form\"\nits control points: how many, and on what\n(square\\-9 triangle\\-7 square\\-7)\nDefault: square\\-9.\n|.SS check\n",
     ""},
    {"$BATTEN help --as completion > c.sh && bash -c '. ./c.sh; COMP_WORDS=(batten bui); COMP_CWORD=1; _batten; echo \"${COMPREPLY[@]}\"'",
     0, "=build\n", ""},
    {"bash -c '. ./c.sh; COMP_WORDS=(batten build --al); COMP_CWORD=2; _batten; echo \"${COMPREPLY[@]}\"'",
     0, "=--allow-outside\n", ""},
    {"bash -c '. ./c.sh; COMP_WORDS=(batten help conic-p); COMP_CWORD=2; _batten; echo \"${COMPREPLY[@]}\"'",
     0, "=conic-pair\n", ""},
    {"for f in $($BATTEN help features | sed -n 's/^  \\([a-z][a-z0-9-]*\\) .*/\\1/p'); do $BATTEN help $f | grep \"^$f: \" > /dev/null || echo $f; done",
     0, "", ""},
    /* No option has a letter that cannot be typed, and no command one letter twice. */
    {"for c in $($BATTEN help | sed -n 's/^  \\([a-z-]*\\)  .*/\\1/p'); do $BATTEN help $c; done | tr -d '\\n' | LC_ALL=C grep -c '[[:cntrl:]]'",
     1, "=0\n", ""},
    {"for c in $($BATTEN help | sed -n 's/^  \\([a-z-]*\\)  .*/\\1/p'); do $BATTEN help $c | sed -n 's/^  --[^ ]*.*, -\\([a-z]\\) .*/\\1/p' | sort | uniq -d; done",
     0, "", ""},
    {"$BATTEN help --as literature", 0,
     "## Every feature and its sources\n\n| feature | other names | sources |\n|---|---|---|\n| `read` | ",
     ""},
    {"test $($BATTEN help --as literature | sed -n '/^## Every/,$p' | grep -c '^| `') = $($BATTEN help features | grep -c '^  [a-z]')",
     0, "", ""},
    {"for c in build convert info; do $BATTEN help $c | sed -n 's/^\\(  --.*\\)/\\1/p' | cut -c27-28 | sort -u; done",
     0, "=  \n  \n  \n", ""},
    {"$BATTEN build --help | head -1", 0,
     "=usage: batten build DESIGN [-o DIR] [--set NAME=VALUE] [--only FEATURE]\n", ""},
    /* A plural finds the word; of three letters or with a double s the s is the word's own. */
    {"$BATTEN help cuts | tail -n +2 > cuts; $BATTEN help cut | tail -n +2 | diff cuts -", 0,
     "=", ""},
    {"$BATTEN help cut", 0, "  split    ", ""},
    {"$BATTEN --version", 0, "batten ", ""},
    {"$BATTEN help elipse", 2, "", "there is no topic 'elipse'; did you mean 'ellipse'; see"},
    {"$BATTEN help skins", 0, "'skins' is found in:\n\n|Or did you mean 'skin'?\n", ""},
    {"$BATTEN help clothoid", 0,
     "'clothoid' is found in:\n\n|'batten help NAME' describes one of them.\n|!did you mean",
     ""},
};

TEST(help_has_a_topic_for_every_command_and_feature)
{
    RUN_LINES(topics);
}

/* What is looked for, and the feature that stands first. */
static const struct {
    const char *words, *first;
} searches[] = {
    {"mechanical spline", "elastica"},
    {"Cornu spiral", "euler-spiral"},
    {"Wielinga", "constrained"},
    {"unisurf", "bezier"},
    {"Ferguson", "interpolate"},
    {"Overhauser", "bessel"},
    {"cumulative chord", "interpolate"},
    {"multi-section surface", "skin"},
    {"rail", "two-rails"},
    {"zebra", "contours"},
    {"comb", "picture"},
    {"dxf", "read"},
    {"NURBS", "b-spline-surface"},
    {"KURGLA", "mehlum"},
    {"Metafont", "hobby"},
    {"Bézier patch", "bezier-surface"},
    {"bridge curve", "blend"},
    {"birail", "two-rails"},
    {"n-sided", "gregory"},
    {"oriented bounding box", "box"},
    {"PCHIP", "fritsch-butland"},
    {"shading", "picture"},
    {"Remez", "minimax"},
    {"section III.6", "interpolate"},
    {"formula 12.7.14", "help"},
    {"Douglas-Peucker", "thin-points"},
};

TEST(words_of_books_authors_and_other_programs_lead_to_a_feature)
{
    for (size_t i = 0; i < sizeof searches / sizeof searches[0]; i++) {
        char command[80], first[80];
        snprintf(command, sizeof command, "$BATTEN help %s", searches[i].words);
        snprintf(first, sizeof first, "' is found in:\n\n  %s ", searches[i].first);
        const line_row row[] = {{command, 0, first, ""}};
        RUN_LINES(row);
    }
}

TEST(a_place_in_the_literature_leads_to_the_features_that_stand_on_it)
{
    static const line_row rows[] = {
        {"$BATTEN help Su and Liu III.7", 0,
         "  section III.7 (|: cornered-spline, directed-spline, tangents-and-curvatures\n|of Su Buqing and Liu Dingyuan, ",
         ""},
        {"$BATTEN help paper 10", 0, "  paper 10 (Nielson|: nu-spline, directed-spline, ", ""},
        {"$BATTEN help paper 2", 0, "a survey: its methods are those of the other papers", ""},
        {"$BATTEN help formula 12.7.14", 0, "  formula 12.7.14 (|: interpolate-grid\n", ""},
        {"$BATTEN help elastica", 0,
         "Also known as: mechanical spline, |Formula:\n\n    2 κ″ + κ³ = 0 |Sources:\n  Su Buqing and Liu Dingyuan, |, section VI.3\n",
         ""},
    };
    RUN_LINES(rows);
}
