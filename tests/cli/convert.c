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
    CHECK_CONTAINS(run.out, ": 1 mesh; 1 approximated; left out: 1 curve\n");
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
    CHECK_CONTAINS(run.errors, "left out, as it cannot be meshed");
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
    CHECK_CONTAINS(run.errors,
                   "the file does not say its unit; its numbers are taken to be in mm");
    run = RUN("batten", "convert", path, out, "--from-unit", "m", "--unit", "mm", "--text");
    CHECK(strstr(run.errors, "does not say its unit") == NULL);
    CHECK_CONTAINS(test_content(out), "1000 0 0");
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
