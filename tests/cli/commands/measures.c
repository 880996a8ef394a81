#include "cli/lines.h"

/* What each command says of shapes whose measures are known. The shapes: see lines.c. */

#define MADE "$BATTEN build -q all.yaml && "

TEST(eval_prints_points_and_derivatives_as_numbers_or_json)
{
    static const line_row rows[] = {
        {MADE "$BATTEN eval one.igs --at .5", 0, "=2 0 0\n", "one.igs"},
        {"$BATTEN eval one.igs --at .5 --order 2", 0, "=2 0 0\n4 0 0\n0 0 0\n", NULL},
        {"$BATTEN eval one.igs --at 0 --at 1", 0, "=0 0 0\n4 0 0\n", NULL},
        {"$BATTEN eval one.igs --at .5 --order 1 --json", 0,
         "={\"results\": [\n    {\"object\": \"one\", \"at\": [0.5], \"point\": [2, 0, 0], \"derivatives\": [[4, 0, "
         "0]]}\n]}\n",
         NULL},
        {"$BATTEN eval one.igs --at 0 --at 1 --json", 0,
         "\"derivatives\": []},\n    {\"object\": \"one\", \"at\": [1]", NULL},
        {"$BATTEN eval one.igs --at 1.5", 2, "", "batten eval: "},
        {"$BATTEN eval one.igs --at 1.5 --beyond refuse", 2, "", "batten eval: "},
        {"$BATTEN eval one.igs --at 1.5 --beyond linear", 0, "=6 0 0\n", NULL},
        {"$BATTEN eval one.igs --at=-1 --beyond continue", 0, "=-4 0 0\n", NULL},
        {"$BATTEN eval one.igs --at 1 --beyond far", 2, "",
         "--beyond wants refuse, continue or linear, not 'far'"},
        {"$BATTEN eval sheet.step --at .5,1 --order 1", 0, "=2 3 0\n4 0 0\n0 3 0\n", NULL},
        {"$BATTEN eval sheet.step --at .5", 2, "",
         "'sheet' is not a curve, so 1 parameter does not fit"},
        {"$BATTEN eval one.igs --at .5,.5", 2, "",
         "'one' is not a surface, so 2 parameters do not fit"},
        {"$BATTEN eval all.step --at 0", 0, "=0 0 0\n2 0 0\n", NULL},
        {"$BATTEN eval all.step --at 0,.5 --json", 0, "\"sheet\"|\"ball\"|!\"one\"", NULL},
        {"$BATTEN eval ducks.xyz --at 0 --from-format points", 2, "",
         "'points' is not a curve"},
        {"printf '0 0\\n1 1\\n\\n2 2\\n3 3\\n' | $BATTEN eval - --at 0", 2, "",
         "no object takes these parameters"},
        {"$BATTEN eval one.igs", 2, "", "--at U or --at U,V is missing"},
        {"$BATTEN eval one.igs --at 1,", 2, "",
         "--at wants U or U,V, finite numbers, not '1,'"},
        {"$BATTEN eval one.igs --at 0 --order 11", 2, "",
         "--order wants a whole number from 0 to 10, not '11'"},
        {"$BATTEN eval one.igs --at 0 --order 10 | wc -l", 0, "11", NULL},
        {"$BATTEN eval one.igs --at 0 --order 1.5", 2, "",
         "whole number from 0 to 10, not '1.5'"},
        {"$BATTEN eval one.igs --at 0 --from-format ige", 2, "",
         "there is no format 'ige'; did you mean 'iges'?"},
        {"$BATTEN eval none.igs --at 0", 1, "", "none.igs"},
    };
    RUN_LINES(rows);
}

TEST(info_counts_objects_and_names_their_kind_degree_and_box)
{
    static const line_row rows[] = {
        {MADE "$BATTEN info all.step", 0,
         "all.step: 4 objects (2 curves, 2 surfaces), unit m\n|one: curve, degree 1, 2 points, domain [0, 1]\n    box "
         "of the control points 0 0 0  to  4 0 0\n|ring: rational curve, degree 2, 9 points, closed, domain [0, "
         "1]\n|sheet: surface (nurbs), degree 1 x 1, 2 x 2 points, domain [0, 1] x [0, 1]\n|ball: rational surface "
         "(nurbs), degree 2 x 2, 9 x 5 points, closed in u, domain",
         "ball: a pole: its border where v begins is one point|ball: a pole: its border where v ends|!sheet: a pole"},
        {"$BATTEN info one.igs", 0, "one.igs: 1 object, unit m\none: curve", NULL},
        {"$BATTEN info all.step --no-lint", 0, "4 objects", "!a pole"},
        {"$BATTEN info all.step#ring", 0, "1 object, unit m\nring: rational curve", NULL},
        {"$BATTEN info all.step#rnig", 1, "", "there is no object 'rnig' in the file; |'ring'"},
        {"$BATTEN info one.igs --json", 0,
         "{\"file\": \"one.igs\", \"unit\": \"m\",\n  \"objects\": [\n    {\"name\": \"one\", \"type\": \"curve\", "
         "\"kind\": \"nurbs\", \"dimension\": 3, \"degree\": [1], \"points\": [2], \"rational\": false, \"closed\": "
         "[false], \"domain\": [[0, 1]], \"layer\": \"\", \"group\": \"\", \"hidden\": false, \"box\": [[0, 0, 0], [4, "
         "0, 0]], \"box_of\": \"control points\"}],\n  \"messages\": [",
         ""},
        {"$BATTEN info all.step --json", 0,
         "\"degree\": [2, 2], \"points\": [9, 5], \"rational\": true, \"closed\": [true, false], \"domain\": [[0, 1], [0, "
         "1]]",
         ""},
        {"$BATTEN info ducks.xyz", 0,
         "ducks.xyz: 1 object, unit not stated\npoints: points, 4\n    box 0 0 0  to  3 0.9 0\n",
         NULL},
        {"printf '3 1 2\\n-1 5 0\\n2 -4 7\\n' > box.xyz; $BATTEN info box.xyz", 0,
         "points, 3\n    box -1 -4 0  to  3 5 7\n", NULL},
        {"$BATTEN info ducks.xyz --json", 0,
         "\"type\": \"points\", \"kind\": \"row\"|\"points\": [4]|\"degree\": []", NULL},
        {"$BATTEN convert -q sheet.step s.stl; $BATTEN info s.stl", 0,
         "mesh: mesh, 2 triangles, 4 vertices, 1 piece, not watertight: 4 edges at the rim\n    box 0 0 0  to  4 3 0",
         "mesh: edges of one triangle, its rim: 4"},
        {"$BATTEN info s.stl --json", 0,
         "\"triangles\": 2, \"vertices\": 4, \"pieces\": 1, \"coloured_faces\": 0, \"watertight\": false, "
         "\"rim_edges\": 4, \"wrong_edges\": 0, \"crowded_edges\": 0",
         NULL},
        {"$BATTEN convert -q all.step#ball b.stl --chord 0.1; $BATTEN info b.stl", 0,
         "1 piece, watertight\n", "!rim"},
        {"printf 'solid t\\nfacet normal 0 0 0\\nouter loop\\nvertex 0 0 0\\nvertex 1 0 0\\nvertex 0 1 "
         "0\\nendloop\\nendfacet\\nendsolid t\\n' > t.stl; $BATTEN info t.stl",
         0, "1 triangle, 3 vertices, 1 piece, not watertight: 3 edges at the rim", NULL},
        {"printf 'v 0 0 0\\nv 1 0 0\\nv 0 1 0\\nv 1 1 0\\nv 9 9 9\\nf 1 2 3\\nf 2 4 3\\nf 2 4 3\\n' > w.obj; $BATTEN info w.obj",
         0, "3 triangles, ",
         "w.obj: 1 of 5 vertices belong to no element|edges of more than two triangles: 1|its rim: 2"},
        {"printf 'station\\\\height, 0.1, 0.25, 0.5\\n0, , 0.40, 0.70\\n1.2, 0.15, 0.60, 0.90\\n' > t.csv; $BATTEN info "
         "t.csv",
         0, "offsets, 2 stations, 3 lines\n    box 0 0.15 0.1  to  1.2 0.9 0.5\n", NULL},
        {"$BATTEN info t.csv --json", 0,
         "\"type\": \"offsets\", \"kind\": \"table\"|\"points\": [2, 3]", NULL},
    };
    RUN_LINES(rows);
}

TEST(measure_finds_the_measures_of_simple_shapes)
{
    static const line_row rows[] = {
        {MADE "$BATTEN measure all.step", 0,
         "unit m\nsheet: area 12\n|ball: area 12.5663706\n|one: length 4\n|ring: closed, length 12.5663706\n  box -2 -2 0  to  2 2 0|area 12.5663706 in the xy-plane|turning number 1",
         NULL},
        {"$BATTEN measure sheet.step --unit mm", 0, "unit mm\nsheet.step: area 12000000\n",
         NULL},
        {"$BATTEN measure -q sheet.step --json", 0, "\"area\": 12", ""},
        {"$BATTEN measure ducks.xyz", 0, "4", NULL},
        {"$BATTEN measure none.step", 1, "", "none.step"},
    };
    RUN_LINES(rows);
}

TEST(convert_counts_what_it_reads_and_writes)
{
    static const line_row rows[] = {
        {MADE "$BATTEN convert sheet.step s.stl", 0,
         "=read 1 surface; unit m\nwrote s.stl: 1 mesh\n",
         "sheet: meshed exactly by 2 triangles"},
        {"$BATTEN convert all.step all.igs", 0,
         "=read 2 curves, 2 surfaces; unit m\nwrote all.igs: 2 curves, 2 surfaces\n", NULL},
        {"$BATTEN convert all.step all.igs --unit mm", 0,
         "unit m\nwrote all.igs: 2 curves, 2 surfaces; unit mm\n", NULL},
        {"$BATTEN eval all.igs#one --at 1", 0, "=4000 0 0\n", NULL},
        {"$BATTEN convert -q all.step out.igs --json", 0,
         "{\"from\": \"all.step\", \"to\": \"out.igs\", \"format\": \"iges\", \"objects\": 4, \"unit\": \"m\",\n  \"read\": "
         "{\"curves\": 2, \"surfaces\": 2}, \"written\": {\"curves\": 2, \"surfaces\": 2}, \"left_out\": {}, "
         "\"approximated\": 0, \"faces_left_out\": 0,\n  \"messages\": [",
         ""},
        {"$BATTEN convert all.step all.dxf", 0, "wrote all.dxf: |left out: 2 surfaces", NULL},
        {"$BATTEN convert -q ducks.xyz d.csv && cat d.csv", 0,
         "=0,0,0\n1,0.6,0\n2,0.1,0\n3,0.9,0\n", NULL},
        {"$BATTEN convert ducks.xyz -o d.step --from-unit mm", 0,
         "read 1 row of points; unit not stated\nwrote d.step: 1 row of points; unit mm\n",
         NULL},
        {"$BATTEN convert ducks.xyz d.step --unit mm", 0, NULL,
         "the file gives no unit; its numbers are taken to be in mm already (--from-unit says otherwise)"},
        {"$BATTEN convert ducks.xyz d.step --unit furlnog", 2, "",
         "--unit: unknown unit of length 'furlnog'; known are m, mm"},
        {"$BATTEN convert ducks.xyz d.step --from-unit x", 2, "",
         "--from-unit: unknown unit of length 'x'"},
        {"$BATTEN convert ducks.xyz d.foo", 2, "",
         "the ending of 'd.foo' names no format that can be written; --format may"},
        {"$BATTEN convert -q ducks.xyz d.foo --format points && cat d.foo", 0, "1 0.6", NULL},
        {"$BATTEN convert ducks.xyz ducks.xyz", 2, "", "ducks.xyz"},
        {"$BATTEN convert ducks.xyz", 2, "", NULL},
        {"$BATTEN convert ducks.xyz a.step -o b.step", 2, "", NULL},
        {"$BATTEN convert all.step none.xyz", 1, "",
         "batten convert: the model has no points to write"},
        {"$BATTEN convert -q sheet.step s.step && grep -c \"PRODUCT('\" s.step", 0, "1", NULL},
        {"$BATTEN convert -q sheet.step s.step --title hull && grep -c \"PRODUCT('hull'\" s.step",
         0, "1", NULL},
        {"$BATTEN convert -q ducks.xyz t.step && grep -c \"PRODUCT('ducks'\" t.step", 0, "1",
         NULL},
        {"$BATTEN convert -q sheet.step s.stl --text && head -c 5 s.stl", 0, "solid", NULL},
        {"$BATTEN convert -q sheet.step s.step --schema ap242 && grep -c AP242 s.step", 0, NULL,
         NULL},
        {"$BATTEN convert sheet.step s.step --schema ap999", 2, "", "ap999"},
        {"$BATTEN convert sheet.step s.stl --chord 0", 2, "",
         "--chord is 0; it must be above 0"},
        {"$BATTEN convert sheet.step s.stl --chord far", 2, "",
         "--chord wants a length, as 0.1 or 0.1mm, not 'far'"},
        {"$BATTEN convert sheet.step s.stl --angle 0", 2, "", "--angle"},
        {"printf 'station\\\\height, 0.1, 0.25, 0.5\\n0, , 0.40, 0.70\\n1.2, 0.15, 0.60, 0.90\\n' > t.csv; $BATTEN convert t.csv t.step",
         1, "",
         "'batten fit' and designs ('batten help build') make curves and surfaces of a table of offsets"},
    };
    RUN_LINES(rows);
}

TEST(lengths_of_options_have_units)
{
    static const line_row rows[] = {
        {MADE
         "$BATTEN convert -q all.step#ball b.stl --chord 100mm; $BATTEN convert -q all.step#ball c.stl --chord 0.1; cmp b.stl "
         "c.stl && echo same",
         0, "=same\n", NULL},
        {"$BATTEN convert -q all.step#ball b.stl --unit mm --chord 100; $BATTEN convert -q all.step#ball c.stl --unit mm --chord "
         "0.1m; cmp b.stl c.stl && echo same",
         0, "=same\n", NULL},
        {"$BATTEN convert -q all.step#ball b.stl --chord '10 cm'; cmp -s b.stl c.stl && echo same",
         1, "", NULL},
        {"$BATTEN convert ducks.xyz d.step --tolerance 1mm", 1, "",
         "--tolerance is 1mm, and the file gives no unit; --from-unit may"},
        {"$BATTEN convert ducks.xyz d.step --tolerance 1", 0, "wrote d.step", NULL},
        {"$BATTEN convert ducks.xyz d.step --tolerance '1 furlnog'", 2, "",
         "--tolerance wants a length, as 0.1 or 0.1mm, not '1 furlnog'"},
    };
    RUN_LINES(rows);
}

TEST(fit_and_fair_write_what_they_are_asked_for)
{
    static const line_row rows[] = {
        {"$BATTEN fit ducks.xyz -o c.igs && $BATTEN eval c.igs --at 0", 0,
         "ducks.xyz      read|result         interpolate|wrote c.igs\n0 0 0\n", NULL},
        {"$BATTEN fit ducks.xyz -o c.igs --method polyline -q && $BATTEN info c.igs", 0,
         "degree 1, 4 points", NULL},
        {"$BATTEN fit ducks.xyz -o c.igs --method interpolate:degree=2 -q && $BATTEN info c.igs",
         0, "degree 2", NULL},
        {"$BATTEN fit ducks.xyz -o c.igs --degree 1 -q && $BATTEN info c.igs", 0, "degree 1",
         NULL},
        {"$BATTEN fit ducks.xyz -o c.svg -q && head -c 300 c.svg", 0, "<svg", NULL},
        {"$BATTEN fit ducks.xyz -o c.igs --json", 0,
         "{\"features\": [|\"name\": \"result\", \"operation\": \"interpolate\"|\"outputs\": [\"c.igs\"]",
         ""},
        {"$BATTEN fit ducks.xyz", 2, "",
         "batten fit: -o OUT is missing; see 'batten help fit'"},
        {"$BATTEN fit ducks.xyz -o c.igs --method interpolat", 2, "",
         "there is no method 'interpolat'; did you mean 'interpolate'; see 'batten help features'"},
        {"$BATTEN fit ducks.xyz -o ducks.xyz", 2, "", "ducks.xyz"},
        {"$BATTEN fit ducks.xyz -o - --method polyline | head -c 13", 0, "ISO-10303-21;", ""},
        {"$BATTEN fit none.xyz -o c.igs", 1, "", "none.xyz"},
        {"$BATTEN fair ducks.xyz -o f.csv --within 1mm && cat f.csv", 0,
         "points moved, at most 0.001 m, excess inflections 0 -> 0\nwrote f.csv\nx_m,y_m,z_m\n0,0,0\n",
         NULL},
        {"$BATTEN fair ducks.xyz -o f.csv --within 1mm -q", 0, "",
         "the points it was made from are written"},
        {"$BATTEN fair ducks.xyz -o f.png --within 1mm -q && head -c 4 f.png | tail -c 3", 0,
         "PNG", ""},
        {"$BATTEN fair ducks.xyz -o - --within 1mm | head -1", 0, "x_m,y_m,z_m", NULL},
        {"$BATTEN fair ducks.xyz -o f.csv", 2, "",
         "batten fair: --within TOL is missing; see 'batten help fair'"},
        {"$BATTEN fair ducks.xyz --within 1mm", 2, "",
         "batten fair: -o OUT is missing; see 'batten help fair'"},
    };
    RUN_LINES(rows);
}

TEST(compare_leaves_out_what_fails_and_refuses_what_is_unknown)
{
    static const line_row rows[] = {
        {"$BATTEN compare ducks.xyz -o c.svg -m polyline,akima", 0,
         "feature |energy|\npolyline |\nakima |4.40261", NULL},
        {"$BATTEN compare ducks.xyz -o c.svg -m akima -q", 0, "", ""},
        {"$BATTEN compare ducks.xyz -o - -m akima | head -c 300", 0, "<svg|!energy", NULL},
        {"$BATTEN compare ducks.xyz -o c.svg -m akima,conic-pair:start-angle=0:end-angle=0", 0,
         "\nakima |!conic-pair", "left out: |a conic pair has 2 points, not 4"},
        {"$BATTEN compare ducks.xyz -o c.svg -m conic-pair:start-angle=0:end-angle=0", 1, "",
         "batten compare: no method makes a curve of these points"},
        {"$BATTEN compare ducks.xyz -o c.svg -m akima,nonsense", 2, "",
         "there is no method 'nonsense'"},
        {"$BATTEN compare ducks.xyz -o c.svg -m akima,,bessel", 2, "",
         "batten compare: unknown method ''"},
        {"$BATTEN compare ducks.xyz -o c.txt", 2, "",
         "-o PICTURE is needed, which ends in .png, .svg or .pdf"},
        {"$BATTEN compare ducks.xyz", 2, "", "-o PICTURE is needed"},
        {"$BATTEN compare ducks.xyz -o c.svg -m $(yes akima | head -64 | paste -sd,) -q", 1,
         NULL, NULL},
        {"$BATTEN compare ducks.xyz -o c.svg -m $(yes akima | head -65 | paste -sd,)", 2, "",
         "batten compare: more than 64 methods"},
        {"$BATTEN compare ducks.xyz -o c.svg -m akima --unit mm", 0, "in mm", NULL},
        {"$BATTEN compare ducks.xyz -o c.svg -m akima --title akima -q", 0, "", NULL},
    };
    RUN_LINES(rows);
}

TEST(check_and_draw_work_on_files_and_designs)
{
    static const line_row rows[] = {
        {"$BATTEN check all.yaml", 0,
         "What was done\n  ducks (points)\n  bow (interpolate)\n|Verdict: fair as a curve.",
         ""},
        {"$BATTEN check all.yaml --json", 0, "{|\"bow\"|!Verdict", ""},
        {"sed '/report/d' all.yaml > plain.yaml; $BATTEN check plain.yaml", 1, "",
         "the design has no output such as 'report.txt: {check: FEATURE}'"},
        {"$BATTEN check plain.yaml --json", 1, "",
         "the design has no output such as 'report.json: {check: FEATURE}'"},
        {"$BATTEN check all.yaml --unit mm", 2, "",
         "--unit is for files of shapes; 'all.yaml' is a design, which says so itself"},
        {"$BATTEN check all.yaml --from-format step", 2, "",
         "--from-format is for files of shapes"},
        {"$BATTEN check all.yaml -q --within 1mm --json", 2, "",
         "--within is for files of shapes; 'all.yaml' is a design"},
        {"$BATTEN check all.yaml --angle 1deg", 2, "", "--angle is for files of shapes"},
        {"$BATTEN check all.yaml --curvature 0.1", 2, "", "--curvature is for files of shapes"},
        {"$BATTEN check all.yaml --allow-outside --threads 2 --quiet", 0, "Verdict", ""},
        {"cp all.yaml all.YML && $BATTEN check all.YML", 0, "Verdict: fair as a curve.", ""},
        {MADE "$BATTEN check one.igs", 0, "one", NULL},
        {"$BATTEN check -q one.igs --json", 0, "{", ""},
        {"$BATTEN check none.yaml", 1, "", "none.yaml"},
        {"$BATTEN draw all.step -o all.svg && head -c 300 all.svg", 0, "wrote all.svg|<svg",
         NULL},
        {"$BATTEN draw -q all.step -o all.png && head -c 4 all.png | tail -c 3", 0, "PNG",
         NULL},
        {"$BATTEN draw one.igs -o - | head -c 300", 0, "<svg|!wrote", NULL},
        {"$BATTEN draw one.igs", 2, "",
         "batten draw: -o PICTURE is missing; see 'batten help draw'"},
        {"$BATTEN draw one.igs -o a.txt", 2, "", "'a.txt' ends neither in .svg, .pdf nor .png"},
        {"$BATTEN draw -q one.igs -o a.svg --lines-plan", 1, "", "batten draw: "},
    };
    RUN_LINES(rows);
}
