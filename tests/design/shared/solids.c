#include "design/expect.h"
#include "support/bodies.h"

#include <batten/exchange.h>

/* A box 3 x 2 x 1, whose measures are known: as a body, as a mesh, and as points. */

static void write_box(void)
{
    batten_model *model = NULL;
    batten_body *box = test_box((batten_vec3){0, 0, 0}, (batten_vec3){3, 2, 1});
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_model_add(
        model, &(batten_object){
                   .name = "block", .layer = "", .kind = BATTEN_OBJECT_BODY, .body = box}));
    CHECK_OK(batten_write_file(model, test_scratch("box.step"), NULL, NULL));
    batten_model_unref(model);
    batten_body_unref(box);
    FILE *file = fopen(test_scratch("table.csv"), "w");
    CHECK(file != NULL);
    fputs("x_m,z_m,half_breadth_m,line\n0,1,2,a\n0,3,4,b\n5,1,6,a\n5,3,7,b\n", file);
    fclose(file);
}

TEST(a_box_has_its_area_volume_centroid_and_counts)
{
    static const char solids[] =
        "  block: {read: box.step}\n"
        "  table: {read: table.csv}\n"
        "  mesh: {mesh: block}\n"
        "  net: {points: [[0, 0, 0], [3, 0, 0], [0, 2, 0], [3, 2, 0]], columns: 2}\n"
        "  sheet: {bezier-surface: net}\n"
        "  open: {mesh: sheet}\n"
        "  row: {points: [[3, 1, 2], [-1, 5, 0], [2, -4, 7]]}\n"
        "  lone: {points: [[3, 1, 2]]}\n";
    static const expect_row rows[] = {
        {"m.txt: {measure: block}", BATTEN_OK,
         "block: body, closed, area 22|, volume 6|\n  centroid of the volume 1.5 1 0.5\n  box 0 0 0  to  3 2 1\n  1 shell, 6 faces, 12 "
         "edges, 8 vertices; length of all edges 24\n"},
        {"m.json: {measure: block}", BATTEN_OK,
         "\"type\": \"body\", \"closed\": true, \"area\": 2|, \"area_error\": |, \"volume\": |, \"volume_error\": |, \"centroid\": [1.5|, "
         "\"box\": [[|\"box_error\": |, \"edge_length\": 24, \"shells\": 1, \"faces\": 6, \"edges\": 12, \"vertices\": "
         "8}|!unmeasured"},
        {"m.txt: {measure: mesh}", BATTEN_OK,
         "mesh, closed, area 22, volume 6\n  centroid of the volume 1.5 1 0.5\n  box 0 0 0  to  3 2 1\n  12 triangles, 8 vertices, 18 "
         "edges, 1 piece\n|!not closed"},
        {"m.txt: {measure: open}", BATTEN_OK,
         "mesh, not closed, area 6\n  centroid of the area 1.5 1 0\n|2 triangles, 4 vertices, 5 edges, 1 piece\n  not closed for 4 edges "
         "at the rim\n"},
        {"m.json: {measure: mesh}", BATTEN_OK,
         "\"type\": \"mesh\", \"closed\": true, \"area\": 22, |\"volume\": 6|\"centroid\": [1.5, 1, 0.5]|\"triangles\": 12, \"vertices\": 8, "
         "\"edges\": 18, \"pieces\": 1, \"rim_edges\": 0, \"wrong_edges\": 0, \"crowded_edges\": 0}"},
        {"m.txt: {measure: row}", BATTEN_OK, "row: 3 points\n  box -1 -4 0  to  3 5 7\n"},
        {"m.txt: {measure: lone}", BATTEN_OK, "lone: 1 point\n  box 3 1 2  to  3 1 2\n"},
        {"m.json: {measure: row}", BATTEN_OK,
         "\"type\": \"points\", \"count\": 3, \"box\": [[-1, -4, 0], [3, 5, 7]]}"},
        {"m.txt: {measure: table}", BATTEN_OK,
         "table of offsets, 4 points, 2 stations, 2 lines\n  box 0 2 1  to  5 7 3\n"},
        {"m.json: {measure: table}", BATTEN_OK,
         "\"type\": \"offsets\", \"count\": 4, \"stations\": 2, \"lines\": 2, \"box\": [[0, 2, 1], [5, 7, 3]]}"},
        {"k.txt: {check: block}", BATTEN_OK,
         "What was done\n  block (read)\n|block (body)\n    within 1e-06: 12 shared edges\n"},
        {"k.json: {check: block}", BATTEN_OK, "\"ok\": true"},
        {"k.txt: {check: open}", BATTEN_OK, "not closed"},
        {"k.json: {check: [block, mesh], within: 0.001}", BATTEN_OK, "\"ok\": true"},
        {"k.json: {check: open, within: 0.001}", BATTEN_OK, "\"ok\": false"},
    };
    write_box();
    EXPECT_OUTPUTS(solids, rows);
}
