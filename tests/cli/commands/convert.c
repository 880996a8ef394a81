#include <batten/exchange.h>

#include "support/bodies.h"
#include "support/process.h"

#include <stdio.h>
#include <string.h>

/* A tank and a curve as a STEP file of this program. */
static const char *write_tank(void)
{
    const char *design = test_scratch("tank.yaml");
    test_write(design, "batten: 1\nunits: mm\nfeatures:\n  tank: {cylinder: 20, height: 50}\n"
                       "  rim: {circle: 20}\noutputs:\n  tank.step: [tank, rim]\n");
    CHECK_INT(RUN("batten", "build", design, "-q").exit, 0);
    return test_scratch("tank.step");
}

TEST(convert_counts_what_is_read_and_written)
{
    const char *tank = write_tank(), *mesh = test_scratch("tank.stl");
    test_process run = RUN("batten", "convert", tank, mesh, "--chord", "0.05", "--text");
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, "read 1 curve, 1 surface; unit mm\n");
    CHECK_CONTAINS(run.out, ": 1 mesh; 1 shape approximated; left out: 1 curve\n");
    CHECK_CONTAINS(run.errors, "approximated within 0.0");
    CHECK_CONTAINS(test_content(mesh), "facet normal");
    run = RUN("batten", "convert", tank, mesh, "--angle", "10", "--json");
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, "\"read\": {\"curves\": 1, \"surfaces\": 1}");
    CHECK_CONTAINS(run.out, "\"written\": {\"meshes\": 1}, \"left_out\": {\"curves\": 1}");
    CHECK_CONTAINS(run.out, "\"approximated\": 1");
    CHECK_CONTAINS(run.out, "\"format\": \"stl\"");
    CHECK_INT(RUN("batten", "convert", tank, mesh, "--chord", "-1").exit, 2);
}

/* Of a quarter of the cylinder the fewest flat pieces that turn by no more than the angle, each of two facets. */
TEST(convert_turns_normals_of_triangles_by_no_more_than_the_angle)
{
    static const struct {
        const char *angle;
        int pieces;
    } rows[] = {{"10", 9}, {"13", 7}, {"20", 5}};
    const char *tank = write_tank(), *mesh = test_scratch("round.stl");
    for (int i = 0; i < COUNT(rows); i++) {
        CHECK_INT(RUN("batten", "convert", tank, mesh, "--angle", rows[i].angle,
                      "--chord=999mm", "--text")
                      .exit,
                  0);
        int facets = 0;
        for (const char *at = test_content(mesh); (at = strstr(at, "facet normal")); at++)
            facets++;
        CHECK_INT(facets, 4 * 2 * rows[i].pieces);
    }
}

TEST(convert_takes_the_schema_of_STEP)
{
    static const char *const rows[][2] = {
        {"ap203", "CONFIG_CONTROL_DESIGN"}, {"ap214", "AUTOMOTIVE_DESIGN"}, {"ap242", "AP242"}};
    const char *tank = write_tank(), *other = test_scratch("other.step");
    for (int i = 0; i < 3; i++) {
        CHECK_INT(RUN("batten", "convert", tank, other, "--schema", rows[i][0]).exit, 0);
        CHECK_CONTAINS(test_content(other), rows[i][1]);
    }
    CHECK_INT(RUN("batten", "convert", tank, other, "--schema", "ap99").exit, 2);
    CHECK_INT(RUN("batten", "convert", tank, other, "--no-pcurves").exit, 0);
}

TEST(convert_keeps_the_name_of_the_product_or_takes_one)
{
    const char *ply = test_scratch("wedge.v1.ply"), *step = test_scratch("named.step"),
               *again = test_scratch("again.step"), *iges = test_scratch("again.igs");
    test_write(ply,
               "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
               "property float z\nend_header\n1 2 3\n");
    CHECK_INT(RUN("batten", "convert", ply, step, "--from-unit", "mm").exit, 0);
    CHECK_CONTAINS(test_content(step), "=PRODUCT('wedge.v1','wedge.v1',");
    CHECK_INT(RUN("batten", "convert", step, again).exit, 0);
    CHECK_TEXT(test_content(again), test_content(step));
    CHECK_INT(RUN("batten", "convert", step, iges, "--title", "Ship 7").exit, 0);
    CHECK_CONTAINS(test_content(iges), ",6HShip 7,");
    CHECK_INT(RUN("batten", "convert", iges, again).exit, 0);
    CHECK_CONTAINS(test_content(again), "=PRODUCT('Ship 7','Ship 7',");
}

TEST(convert_is_told_formats_that_names_do_not_tell)
{
    const char *tank = write_tank(), *nameless = test_scratch("nameless");
    CHECK_INT(RUN("batten", "convert", tank, nameless).exit, 2);
    CHECK_INT(RUN("batten", "convert", tank, nameless, "--format", "iges").exit, 0);
    CHECK_CONTAINS(test_content(nameless), "S      1");
    CHECK_INT(
        RUN("batten", "convert", nameless, test_scratch("told.step"), "--from-format", "iges")
            .exit,
        0);
    const test_process run =
        RUN("batten", "convert", nameless, test_scratch("told.step"), "--from-format", "igse");
    CHECK_INT(run.exit, 2);
    CHECK_CONTAINS(run.errors, "there is no format 'igse'; did you mean 'iges'?");
}

TEST(convert_of_a_part_of_a_file_is_exit_status_3)
{
    const char *cut = test_scratch("cut.off"), *out = test_scratch("cut.stl");
    test_write(cut, "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 9\n");
    const test_process run = RUN("batten", "convert", cut, out);
    CHECK_INT(run.exit, 3);
    CHECK_CONTAINS(run.out, "read 1 mesh; unit not stated\n");
    CHECK_CONTAINS(run.out, ": 1 mesh\n");
}

/* A face whose border crosses itself, and a whole surface. */
TEST(what_cannot_be_meshed_is_exit_status_3)
{
    static const char plane[] = "200\n3 0\n2 2\n0 0 4 4\n2 2\n0 0 4 4\n"
                                "0 0 1\n4 0 1\n0 4 1\n4 4 1\n";
    static const double corners[][2] = {{1, 1}, {3, 3}, {3, 1}, {1, 3}};
    const char *bow = test_scratch("bow.g2"), *both = test_scratch("both.g2");
    char text[2000];
    size_t used = (size_t)snprintf(text, sizeof text, "210 1 0 0\n%s1\n4 1e-6\n", plane);
    for (int i = 0; i < 4; i++) {
        const double *a = corners[i], *b = corners[(i + 1) % 4];
        used += (size_t)snprintf(text + used, sizeof text - used,
                                 "1 100 0\n2 0\n2 2\n0 0 1 1\n%g %g\n%g %g\n", a[0], a[1], b[0],
                                 b[1]);
    }
    test_write(bow, text);
    test_process run = RUN("batten", "convert", bow, test_scratch("bow.stl"));
    CHECK_INT(run.exit, 1);
    CHECK_CONTAINS(run.errors, "left out, as this body cannot be meshed");
    snprintf(text + used, sizeof text - used, "200 1 0 0\n%s", strchr(plane, '\n') + 1);
    test_write(both, text);
    run = RUN("batten", "convert", both, test_scratch("both.stl"));
    CHECK_INT(run.exit, 3);
    CHECK_CONTAINS(run.out, ": 1 mesh");
}

TEST(numbers_without_a_unit_are_said_to_be_taken_as_they_are)
{
    const char *path = test_scratch("flat.obj"), *out = test_scratch("flat.ply");
    test_write(path, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    test_process run = RUN("batten", "convert", path, out, "--unit", "mm", "--text");
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.errors, "the file gives no unit; its numbers are taken to be in mm");
    run = RUN("batten", "convert", path, out, "--from-unit", "m", "--unit", "mm", "--text");
    CHECK(strstr(run.errors, "gives no unit") == NULL);
    CHECK_CONTAINS(test_content(out), "1000 0 0");
}

TEST(objects_of_one_name_are_counted_by_their_kinds)
{
    const char *path = test_scratch("shared.obj"), *out = test_scratch("shared.stl");
    test_write(path, "v 0 0 0\nv 1 0 0\nv 0 1 0\no same\nf 1 2 3\nl 1 2\nl 2 3\n");
    const test_process run = RUN("batten", "convert", path, out);
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, "read 2 curves, 1 mesh; ");
    CHECK_CONTAINS(run.out, ": 1 mesh; left out: 2 curves\n");
    CHECK_CONTAINS(run.errors, "same: left out: STL files hold meshes, not this curve");
}

TEST(what_is_left_out_is_counted_beyond_the_messages_that_are_shown)
{
    const char *path = test_scratch("many.obj"), *out = test_scratch("many.stl");
    static char text[40000];
    size_t used = (size_t)sprintf(text, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    for (int i = 0; i < 1500; i++)
        used += (size_t)sprintf(text + used, "o l%d\nl 1 2\n", i);
    test_write(path, text);
    CHECK_CONTAINS(RUN("batten", "convert", path, out).out, "left out: 1500 curves\n");
}

TEST(options_of_meshes_that_do_nothing_are_named)
{
    const char *tank = write_tank(), *mesh = test_scratch("tank.stl");
    static const char *const outputs[] = {"idle.obj", "idle.igs", "idle.step", "idle.svg"};
    for (int i = 0; i < COUNT(outputs); i++) {
        const test_process run =
            RUN("batten", "convert", tank, test_scratch(outputs[i]), "--chord", "1", "-q");
        CHECK_INT(run.exit, 0);
        CHECK_CONTAINS(run.errors, "--chord has no effect: nothing becomes triangles in ");
        CHECK_CONTAINS(run.errors, "the feature 'mesh' of a design");
    }
    test_process run = RUN("batten", "convert", tank, mesh, "--chord", "1", "--angle", "180");
    CHECK_INT(run.exit, 0);
    CHECK(strstr(run.errors, "no effect") == NULL);
    run = RUN("batten", "convert", mesh, test_scratch("tank.ply"), "--chord=1", "--angle=9");
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.errors, "--chord and --angle have no effect: there is no shape");
    static const char *const angles[] = {"400", "0", "-20"};
    for (int i = 0; i < COUNT(angles); i++) {
        run = RUN("batten", "convert", tank, mesh, "--angle", angles[i]);
        CHECK_INT(run.exit, 2);
        CHECK_CONTAINS(run.errors, "it must be above 0 and at most 180 degrees");
    }
}

TEST(a_mesh_that_STEP_cannot_hold_brings_the_schema_that_can)
{
    const char *path = test_scratch("one.off"), *out = test_scratch("one.step");
    test_write(path, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    const test_process run = RUN("batten", "convert", path, out);
    CHECK_INT(run.exit, 1);
    CHECK_CONTAINS(run.errors,
                   "is of that kind; those of schema ap242 (--schema ap242) hold meshes");
    CHECK_INT(RUN("batten", "convert", path, out, "--schema", "ap242").exit, 0);
}

TEST(a_plane_is_meshed_and_not_approximated)
{
    const char *design = test_scratch("flat.yaml");
    test_write(design, "batten: 1\nunits: mm\nfeatures:\n"
                       "  a: {line: [[0, 0, 0], [1000, 0, 0]]}\n"
                       "  b: {line: [[0, 1000, 9], [1000, 1000, 9]]}\n"
                       "  c: {ruled: [a, b]}\noutputs:\n  flat.step: c\n");
    CHECK_INT(RUN("batten", "build", design, "-q").exit, 0);
    const test_process run =
        RUN("batten", "convert", test_scratch("flat.step"), test_scratch("flat.stl"));
    CHECK_CONTAINS(run.out, ": 1 mesh\n");
    CHECK_CONTAINS(run.errors, "meshed exactly by 2 triangles");
}

TEST(help_lists_every_format)
{
    const test_process run = RUN("batten", "help", "formats");
    static const char *const names[] = {"step",    "iges",   "g2",       "obj",   "stl", "ply",
                                        "gltf",    "3mf",    "pcd",      "dxf",   "svg", "off",
                                        "offsets", "points", "aerofoil", "g-code"};
    CHECK_INT(run.exit, 0);
    for (int i = 0; i < COUNT(names); i++) {
        char row[20];
        snprintf(row, sizeof row, "\n  %s ", names[i]);
        CHECK_CONTAINS(run.out, row);
    }
}

/* The unit as `info` and `convert` say it. */
static void check_unit(const char *unit, const char *words)
{
    const char *path = test_scratch("unit.dxf"), *other = test_scratch("unit.igs");
    char content[300], wanted[60];
    snprintf(content, sizeof content,
             "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n%s\n0\nENDSEC\n0\nSECTION\n2\n"
             "ENTITIES\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n1\n21\n0\n0\nENDSEC\n0\nEOF\n",
             unit);
    test_write(path, content);
    snprintf(wanted, sizeof wanted, "unit %s\n", words);
    CHECK_CONTAINS(RUN("batten", "info", path).out, wanted);
    CHECK_CONTAINS(RUN("batten", "convert", path, other).out, wanted);
    snprintf(wanted, sizeof wanted, "\"unit\": \"%s\"", words);
    CHECK_CONTAINS(RUN("batten", "info", path, "--json").out, wanted);
    CHECK_CONTAINS(RUN("batten", "convert", path, other, "--json").out, wanted);
}

TEST(units_are_named_or_given_in_metres)
{
    check_unit("10", "yd");
    check_unit("14", "dm");
    check_unit("21", "usft");
    check_unit("17", "1000000000 m");
    const char *path = test_scratch("unit.dxf"), *other = test_scratch("unit.igs");
    CHECK_INT(RUN("batten", "convert", path, other, "--unit", "yd").exit, 0);
}

TEST(convert_of_a_table_to_eighths_is_in_inches)
{
    const char *table = test_scratch("table.csv"), *eighths = test_scratch("eighths.csv");
    test_write(table, "station,z,half_breadth\n24,1.5,2.25\n48,1.5,3\n");
    test_process run = RUN("batten", "convert", table, eighths, "--from-unit", "in", "--unit",
                           "ft", "--eighths");
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, "; unit in\n");
    CHECK_CONTAINS(test_content(eighths),
                   "axis,name,\"24\",\"48\"\nlength,station,2-0-0,4-0-0\n");
    CHECK_CONTAINS(test_content(eighths), "heights,\"z=1.5\",0-1-4,0-1-4\n");
}

TEST(convert_points_to_what_makes_shapes_of_tables_and_points)
{
    const char *table = test_scratch("hull.csv"), *points = test_scratch("row.xyz");
    const char *step = test_scratch("hull.step"), *dxf = test_scratch("row.dxf");
    test_write(table, "station,z,half_breadth\n24,1.5,2.25\n48,1.5,3\n");
    test_write(points, "0 0\n1 1\n2 0\n");
    test_process run = RUN("batten", "convert", table, step);
    CHECK_INT(run.exit, 1);
    CHECK_CONTAINS(run.errors, "'batten fit'");
    run = RUN("batten", "convert", points, dxf);
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.errors, "'batten fit' makes curves");
}

TEST(lengths_have_units)
{
    const char *tank = write_tank(), *mesh = test_scratch("tank.ply");
    static const char *const same[] = {"0.05", "0.05mm", "0.05 mm", "50um", "0.005cm"};
    char triangles[64] = "";
    for (int i = 0; i < COUNT(same); i++) {
        CHECK_INT(RUN("batten", "convert", tank, mesh, "--chord", same[i], "-q").exit, 0);
        const char *found = strstr(test_content(mesh), "element face");
        CHECK(found != NULL);
        if (i == 0 && found)
            snprintf(triangles, sizeof triangles, "%.25s", found);
        CHECK(found && strncmp(found, triangles, strlen(triangles)) == 0);
    }
    CHECK_INT(
        RUN("batten", "convert", tank, mesh, "--chord", "0.05mm", "--unit", "in", "-q").exit,
        0);
    CHECK_CONTAINS(test_content(mesh), triangles);
    test_process run = RUN("batten", "convert", tank, mesh, "--chord", "0.1 potatoes");
    CHECK_INT(run.exit, 2);
    CHECK_CONTAINS(run.errors, "--chord wants a length, as 0.1 or 0.1mm, not '0.1 potatoes'");
    CHECK_INT(RUN("batten", "convert", tank, mesh, "--tolerance", "-1mm").exit, 2);
    const char *off = test_scratch("bare.off");
    test_write(off, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    run = RUN("batten", "convert", off, mesh, "--chord", "1mm");
    CHECK_INT(run.exit, 1);
    CHECK_CONTAINS(run.errors, "the file gives no unit; --from-unit may");
    CHECK_INT(RUN("batten", "convert", off, mesh, "--chord", "1mm", "--from-unit", "mm").exit,
              0);
}

/* As long as nobody asks for another chord, 1/1000 of the size. */
TEST(designs_make_the_meshes_that_convert_makes)
{
    const char *tank = write_tank(), *design = test_scratch("made.yaml");
    const char *first = test_scratch("first.ply"), *second = test_scratch("made.ply");
    CHECK_INT(RUN("batten", "convert", tank, first, "--angle", "20", "-q").exit, 0);
    test_write(design, "batten: 1\nunits: mm\ntolerance: 1e-4 mm\nfeatures:\n"
                       "  tank: {cylinder: 20, height: 50}\noutputs:\n  made.ply: tank\n"
                       "  fine.ply: {write: tank, within: 0.005 mm}\n");
    CHECK_INT(RUN("batten", "build", design, "-q").exit, 0);
    const char *a = strstr(test_content(first), "element face");
    CHECK(a != NULL);
    char count[64];
    snprintf(count, sizeof count, "%.20s", a ? a : "");
    CHECK_CONTAINS(test_content(second), count);
    CHECK(!strstr(test_content(test_scratch("fine.ply")), count));
}

/* Three instances of a box and a surface; of the box IGES has six faces. */
TEST(what_instances_hold_is_counted_in_all)
{
    const char *parts = test_scratch("parts.igs"), *path = test_scratch("placed.step");
    batten_model *inner = NULL, *outer = NULL;
    batten_body *bodies[2] = {test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 1, 1}), NULL};
    batten_surface *patch = NULL;
    const batten_axis line = {1, 2, (const double[]){0, 0, 1, 1}, false};
    const double corners[12] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 1};
    CHECK_OK(batten_surface_create(3, &line, &line, corners, NULL, &patch));
    CHECK_OK(batten_body_from_surface("sheet", patch, 1e-6, &bodies[1]));
    CHECK_OK(batten_model_create(0.001, &inner));
    for (int i = 0; i < 2; i++)
        CHECK_OK(batten_model_add(inner, &(batten_object){.name = i ? "b" : "a",
                                                          .kind = BATTEN_OBJECT_BODY,
                                                          .body = bodies[i]}));
    CHECK_OK(batten_model_create(0.001, &outer));
    for (int i = 0; i < 3; i++)
        CHECK_OK(batten_model_add(
            outer, &(batten_object){.name = "place",
                                    .kind = BATTEN_OBJECT_INSTANCE,
                                    .definition = inner,
                                    .place = batten_affine_translation(2 * i, 0, 0)}));
    CHECK_OK(batten_write_file(outer, path, NULL, NULL));
    test_process run = RUN("batten", "convert", path, parts);
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, "read 3 instances (in all 3 surfaces, 3 solids)");
    CHECK_CONTAINS(run.out, ": 3 instances (in all 3 surfaces, 18 sheets)");
    run = RUN("batten", "convert", path, parts, "--json");
    CHECK_CONTAINS(run.out, "\"read\": {\"instances\": 3, \"in_all\": {\"surfaces\": 3, "
                            "\"bodies\": 3, \"solids\": 3}}");
    batten_model_unref(outer);
    batten_model_unref(inner);
    batten_body_unref(bodies[0]);
    batten_body_unref(bodies[1]);
    batten_surface_unref(patch);
}

TEST(a_loop_that_leaves_its_plane_by_orders_of_magnitude_is_refused_with_its_numbers)
{
    const char *face = test_scratch("far.g2"), *mesh = test_scratch("far.stl");
    /* A square with a hole; one control point of which is at -1e18. */
    test_write(face, "210 1 0 0\n"
                     "200 3 0 2 2 0 0 4 4\n"
                     "2 2 0 0 4 4 0 0 0 4 0 0\n"
                     "0 4 0 4 4 0 2 4 1e-6\n"
                     "1 100 0 2 0 2 2 0 0 1 1\n"
                     "0 0 4 0 1 100 0 2 0\n"
                     "2 2 0 0 1 1 4 0 4 4\n"
                     "1 100 0 2 0 2 2 0 0 1 1\n"
                     "4 4 0 4 1 100 0 2 0\n"
                     "2 2 0 0 1 1 0 4 0 0\n"
                     "1 1e-6 1 100 100 2 0 9 4\n"
                     "0 0 0 0 1 2 3 4 5 6 6 6 6 1 1 1 2 -1e18 3\n"
                     "2 3 3 3 3 2 3 1\n"
                     "2 1 1 1 3 0 9 4\n"
                     "0 0 0 0 1 2 3 4 5 6 6 6 6 1 1 0 1 2 0 -1e18 3 0\n"
                     "2 3 0 3 3 0 3 2 0 3 1 0\n"
                     "2 1 0 1 1 0\n");
    const test_process run = RUN("batten", "convert", face, mesh);
    CHECK_INT(run.exit, 1);
    CHECK_CONTAINS(run.errors, "a loop runs to u = -1e+18, where its plane has 0 to 4");
}

TEST(convert_writes_to_the_standard_output_for_a_dash)
{
    const char *tank = write_tank(), *file = test_scratch("same.igs");
    CHECK_INT(RUN("batten", "convert", tank, file).exit, 0);
    const test_process run = RUN("batten", "convert", tank, "-", "--format", "iges");
    CHECK_INT(run.exit, 0);
    CHECK_TEXT(run.out, test_content(file));
    CHECK_CONTAINS(RUN("batten", "convert", tank, "-o", "-", "--format", "stl", "--text").out,
                   "endsolid");
    CHECK_INT(RUN("batten", "convert", tank, "-").exit, 2);
    CHECK_INT(RUN("batten", "convert", tank, "-", "--format", "iges", "--json").exit, 2);
    char full[600];
    snprintf(full, sizeof full, "\"$BATTEN\" convert '%s' - --format iges > /dev/full", tank);
    CHECK_INT(test_shell(full).exit, 1);
}

TEST(N6_a_tolerance_of_a_loop_that_is_too_coarse_for_its_surface_is_not_believed)
{
    const char *face = test_scratch("coarse.g2");
    test_write(face, "210 1 0 0 200 3 0 2 2\n"
                     "0 0 4 4 2 2 0 0 4 4 0 0 0\n"
                     "4 0 0 0 4 0 4 4 0 2\n"
                     "4 0.9 1 100 0 2 0 2 2\n"
                     "0 0 1 1 0 0 4 0 1 100 0\n"
                     "2 0 2 2 0 0 1 1 4 0\n"
                     "4 4 1 100 0 2 0 2 2\n"
                     "0 0 1 1 4 4 0 4 1 100 0\n"
                     "2 0 2 2 0 0 1 1 0 4\n"
                     "0 0 1 1e-6 1 100 100 2 0\n"
                     "9 4 0 0 0 0 1 2 3 4 5 6 6 6 6 1 1 1 2\n"
                     "1 3 2 3 3 3 3 2\n"
                     "3 1 2 1 1 1 3 0\n"
                     "9 4 0 0 0 0 1 2 3 4 5 6 6 6 6 1 1 0 1 2 0\n"
                     "1 3 0 2 3 0 3 3 0 3 2 0\n"
                     "3 1 0 2 1 0 1 1 0\n");
    const test_process run = RUN("batten", "measure", face);
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(
        run.errors,
        "a loop states a tolerance of 0.9 at a size of 5.65685; 5.65685e-06 is used");
}

TEST(P4_curves_on_surfaces_whose_name_stands_in_REPRESENTATION_ITEM_are_read)
{
    const char *tank = write_tank();
    char rewrite[1200];
    snprintf(
        rewrite, sizeof rewrite,
        "sed -E \"s/=(SURFACE|SEAM)_CURVE\\('',(.*)\\);/=(BOUNDED_CURVE()CURVE()"
        "GEOMETRIC_REPRESENTATION_ITEM()REPRESENTATION_ITEM('')\\1_CURVE(\\2));/\" '%s' > '%s.creo' && "
        "grep -c REPRESENTATION_ITEM\\(\\'\\' '%s.creo' && \"$BATTEN\" convert '%s.creo' - --format stl --text",
        tank, tank, tank, tank);
    const test_process run = test_shell(rewrite);
    CHECK_INT(run.exit, 0);
    CHECK_CONTAINS(run.out, "endsolid");
}
