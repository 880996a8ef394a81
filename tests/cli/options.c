#include "cli/lines.h"

/* Words of a command line: options, values with units, names of formats and of objects. The shapes: see lines.c. */

TEST(options_come_in_long_and_short_forms_with_values_beside_or_behind)
{
    static const line_row rows[] = {
        {"$BATTEN build -q all.yaml && $BATTEN draw one.igs -o- | head -c 5", 0, "<?xml", NULL},
        {"$BATTEN draw -q one.igs -oa.svg && $BATTEN draw -q one.igs -o b.svg && $BATTEN draw -q one.igs --output=c.svg && "
         "$BATTEN draw -q one.igs --output d.svg && ls ?.svg",
         0, "=a.svg\nb.svg\nc.svg\nd.svg\n", ""},
        {"$BATTEN info --from-format", 2, "",
         "batten info: --from-format needs a value: FORMAT"},
        {"$BATTEN info a b", 2, "",
         "batten info: 'b' is one word too many; see 'batten help info'"},
        {"$BATTEN info -x a", 2, "",
         "batten info: there is no option -x; see 'batten help info'"},
        {"$BATTEN info --jason a", 2, "",
         "there is no option --jason; did you mean --json; see 'batten help info'"},
        {"$BATTEN info --json --json a", 2, "", "batten info: --json is given twice"},
        {"$BATTEN draw -o a.svg --output b.svg one.igs", 2, "",
         "batten draw: --output is given twice"},
        {"$BATTEN info --json=yes a", 2, "", "batten info: --json takes no value"},
        {"$BATTEN info", 2, "", "batten info: a file is missing; see 'batten help info'"},
        {"$BATTEN convert ducks.xyz", 2, "", NULL},
        {"$BATTEN info -- -a", 1, "", "cannot open '-a'"},
        {"cp one.igs ./-x.igs; $BATTEN info -- -x.igs", 0, "-x.igs: 1 object", NULL},
        {"$BATTEN info - < one.igs", 0, "1 object", NULL},
        {"$BATTEN info --help | head -1", 0,
         "=usage: batten info IN [--from-format FORMAT] [--json] [--no-lint]\n", ""},
        {"$BATTEN fair ducks.xyz -q -o f.csv --within 1mm --hold-ends=no && head -2 f.csv", 0,
         "!\n0,0,0", NULL},
        {"$BATTEN fair ducks.xyz -q -o f.csv --within 1mm --hold-ends && head -2 f.csv", 0,
         "\n0,0,0", NULL},
    };
    RUN_LINES(rows);
}

TEST(values_of_options_may_be_lists_in_four_forms)
{
    static const line_row rows[] = {
        {"printf '0 0\\n4 0\\n' > two.xyz; for t in '[[1,1],[1,-1]]' '[[1, 1], [1, -1]]'; do $BATTEN fit two.xyz -q -o h.igs --method "
         "hermite --tangents \"$t\" --lengths rule && $BATTEN eval h.igs --at 0 --order 1; done",
         0, "=0 0 0\n1 1 0\n0 0 0\n1 1 0\n", NULL},
        {"$BATTEN fit two.xyz -q -o h.igs --method hermite --tangents 1,1 --tangents 1,-1 --lengths rule && $BATTEN eval h.igs --at 4 --order 1",
         0, "4 0 0\n| -1 0\n", NULL},
        {"$BATTEN fit two.xyz -q -o h.igs --method hermite --tangents '[1,1]' --tangents '[1,-1]' --lengths rule && $BATTEN eval "
         "h.igs --at 4 --order 1",
         0, "4 0 0\n| -1 0\n", NULL},
        {"$BATTEN fit two.xyz -o h.igs --method hermite --tangents '[1,1]'", 2, "",
         "'tangents' has 1 vector for 2 points"},
        {"$BATTEN fit two.xyz -o h.igs --method hermite --tangents '[1,1],[1,-1]'", 2, "",
         "not '[1,1],[1,-1]'"},
        {"$BATTEN fit two.xyz -o h.igs --method hermite --tangents '[1,1]]'", 2, "",
         "not '[1,1]]'"},
        {"$BATTEN fit two.xyz -o h.igs --method hermite --tangents '['", 2, "", "not '['"},
        {"for t in '--amount 5' '--amount 5,5,5' '--amount [5,5,5]' '--amount 5 --amount 5 --amount 5'; do $BATTEN fit ducks.xyz -q "
         "-o t.igs --method tension $t && $BATTEN eval t.igs --at 1.5; done | sort -u | wc -l",
         0, "1", NULL},
        {"$BATTEN fit ducks.xyz -o t.igs --method tension --amount 5,5", 2, "",
         "'amount' has 2 numbers for 3 spans"},
        {"$BATTEN fit ducks.xyz -q -o t.igs --method least-squares --pass 1,.6 --points 4", 0,
         "", NULL},
        {"$BATTEN fit ducks.xyz -q -o t.igs --start direction --start-vector 0,1 && $BATTEN eval t.igs --at 0 --order 1 | tail -1 | cut "
         "-c1-2",
         0, "=0 \n", NULL},
    };
    RUN_LINES(rows);
}

TEST(lengths_have_units_or_are_in_that_of_the_result)
{
    static const line_row rows[] = {
        {"$BATTEN build -q all.yaml && $BATTEN convert -q all.step#ball b.stl --chord 100mm; $BATTEN convert -q all.step#ball c.stl "
         "--chord 0.1; cmp b.stl c.stl && echo same",
         0, "=same\n", NULL},
        {"$BATTEN convert -q all.step#ball b.stl --unit mm --chord 100; $BATTEN convert -q all.step#ball c.stl --unit mm --chord "
         "0.1m; cmp b.stl c.stl && echo same",
         0, "=same\n", NULL},
        {"$BATTEN convert -q all.step#ball d.stl --unit mm --chord '10 cm'; cmp d.stl c.stl && echo same",
         0, "=same\n", NULL},
        {"$BATTEN convert -q all.step#ball d.stl --unit mm --chord '1 mm'; cmp -s d.stl c.stl || echo other",
         0, "=other\n", NULL},
        {"$BATTEN convert ducks.xyz d.step --tolerance 1mm", 1, "",
         "--tolerance is 1mm, and the file gives no unit; --from-unit may"},
        {"$BATTEN convert -q ducks.xyz d.step --tolerance 1mm --from-unit m && $BATTEN info d.step | head -1",
         0, "unit m\n", NULL},
        {"$BATTEN convert ducks.xyz d.step --tolerance '1 furlnog'", 2, "",
         "--tolerance wants a length, as 0.1 or 0.1mm, not '1 furlnog'"},
        {"$BATTEN convert ducks.xyz d.step --tolerance 0", 2, "",
         "--tolerance is 0; it must be above 0"},
        {"$BATTEN convert ducks.xyz d.step --tolerance=-1mm", 2, "",
         "--tolerance is -1mm; it must be above 0"},
        {"$BATTEN convert ducks.xyz d.step --unit 0.5", 2, "", "unknown unit of length '0.5'"},
        {"printf 'batten: 1\\nunits: m\\nfeatures: {c: {circle: 1}}\\noutputs: {c.igs: c}\\n' > c.yaml; $BATTEN build -q c.yaml; "
         "$BATTEN convert -q c.igs d.igs --unit ft; $BATTEN info d.igs | head -1; $BATTEN eval d.igs --at 0",
         0, "unit ft\n3.28083989501", NULL},
    };
    RUN_LINES(rows);
}

TEST(formats_are_named_and_listed_with_their_endings)
{
    static const line_row rows[] = {
        {"$BATTEN help formats", 0,
         "Formats of files:\n\n  name      endings                  read write  what is kept\n  offsets   .csv .tsv .txt           "
         "yes  yes    tables of offsets|\n  g-code    .nc .ngc .gcode .tap     -    yes    chains of lines and arcs|\n  stl       "
         ".stl                     yes  yes    triangles alone, no unit",
         ""},
        {"$BATTEN info --from-format dxff a", 2, "",
         "batten info: --from-format: there is no format 'dxff'; did you mean 'dxf'?; see"},
        {"$BATTEN info --from-format qqqqqqqq a", 2, "",
         "there is no format 'qqqqqqqq'; see 'batten help formats'"},
        {"cp ducks.xyz d.unknown; $BATTEN info --from-format points d.unknown", 0, "points, 4",
         NULL},
        {"$BATTEN info --from-format step ducks.xyz", 1, "", "ducks.xyz"},
    };
    RUN_LINES(rows);
}

TEST(objects_are_chosen_by_name_and_the_nearest_are_named)
{
    static const line_row rows[] = {
        {"$BATTEN build -q all.yaml && $BATTEN info all.step#ring", 0,
         "all.step#ring: 1 object, unit m\nring: ", NULL},
        {"$BATTEN info all.step#x", 1, "",
         "there is no object 'x' in the file; there are '|'ring'|'ball'|'sheet'|'one'|!lists all"},
        {"$BATTEN info one.igs#x", 1, "",
         "there is no object 'x' in the file; there is 'one'\n"},
        {"printf 'batten: 1\\nfeatures:\\n  p: {points: [[0,0],[1,1],[2,0],[3,1],[4,0],[5,1],[6,0],[7,1],[8,0],[9,0],[10,0],[11,0]], "
         "columns: 2}\\n  c: {polyline: p}\\noutputs: {six.step: c}\\n' > six.yaml; $BATTEN build -q six.yaml; $BATTEN info "
         "'six.step#row 9'",
         1, "",
         "there is no object 'row 9' in the file; the nearest names are 'row 1', 'row 2', |'row 5' ('batten info' lists all)"},
        {"$BATTEN info 'six.step#row 6' | tail -1", 0, "10 0 0  to  11 0 0", NULL},
        {"$BATTEN convert -q 'six.step#row 2' two.step && $BATTEN info two.step && grep -c \"PRODUCT('row 2'\" two.step",
         0, "1 object|\n1\n", NULL},
        {"$BATTEN measure -q all.step#one", 0, "length 4", ""},
    };
    RUN_LINES(rows);
}
