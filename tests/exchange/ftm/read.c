#include "exchange/reading.h"

/* Two layers of 12 lines, four points, five edges, one curve, two faces. */
static const char net[] =
    "FREE!ship\n2.6\n1\n2\n"
    "Side\n3\n255\n1\n1\n1\n1\n1\n0\n0\n1\n171\n"
    "Deck\n4\n65280\n1\n1\n1\n1\n1\n0\n0\n1\n171\n"
    "0\n"
    "5\n0 0 0\n1\n0\n0\n1 0 0\n1\n0\n0\n1 1 0\n1\n0\n0\n0 1 0.5\n1\n0\n0\n"
    "2 2 2\n3\n0\n0\n"
    "2\n0\n1\n1\n0\n1\n2\n0\n0\n"
    "1\n2\n0\n1\n0\n"
    "2\n4\n0\n1\n2\n3\n0\n0\n3\n1\n4\n2\n1\n0\n"
    "0\n";

TEST(the_control_net_of_a_ship_is_meshes_by_layer)
{
    batten_model *model =
        read_noting(net, BATTEN_FORMAT_AUTO, "with 1 crease and 1 curve, is not made");
    CHECK_INT(batten_model_count(model), 2);
    const batten_object *side = batten_model_object(model, 0);
    const batten_mesh_parts *mesh = batten_mesh_view(side->mesh);
    CHECK_TEXT(side->name, "Side");
    CHECK_INT(mesh->triangle_count, 2);
    CHECK_INT(mesh->vertex_count, 4);
    CHECK_BITS(mesh->points[11], 0.5);
    CHECK(side->has_colour && side->colour[0] == 1 && side->colour[2] == 0);
    const batten_object *deck = batten_model_object(model, 1);
    CHECK_INT(batten_mesh_view(deck->mesh)->triangle_count, 1);
    CHECK(deck->has_colour && deck->colour[1] == 1);
    batten_model_unref(model);
}

TEST(faces_of_four_corners_of_a_ship_are_counted)
{
    batten_model *model =
        read_noting(net, BATTEN_FORMAT_AUTO, "faces of more than three corners: 1");
    batten_model_unref(model);
}

/* Three layers take turns at four points that they share: each numbers those that it uses as they
 * come. */
TEST(layers_that_share_points_have_them_each)
{
    static const char *const layer = "\n3\n255\n1\n1\n1\n1\n1\n0\n0\n1\n171\n";
    static const struct {
        int layer, corners[3];
    } faces[] = {
        {2, {1, 2, 3}}, {0, {0, 1, 2}}, {2, {3, 0, 1}}, {0, {2, 3, 0}}, {1, {3, 1, 0}}};
    static const int points[3][4] = {{0, 1, 2, 3}, {3, 1, 0, -1}, {1, 2, 3, 0}};
    char text[2000] = "FREE!ship\n2.6\n1\n3\n";
    for (int k = 0; k < 3; k++)
        sprintf(text + strlen(text), "layer %c%s", 'a' + k, layer);
    strcat(text,
           "0\n4\n0 0 0\n1\n0\n0\n1 0 0\n1\n0\n0\n2 1 0\n1\n0\n0\n3 1 1\n1\n0\n0\n0\n0\n5\n");
    for (int i = 0; i < COUNT(faces); i++)
        sprintf(text + strlen(text), "3\n%d\n%d\n%d\n%d\n0\n", faces[i].corners[0],
                faces[i].corners[1], faces[i].corners[2], faces[i].layer);
    strcat(text, "0\n");
    batten_model *model = read_noting(text, BATTEN_FORMAT_AUTO, "is not made");
    CHECK_INT(batten_model_count(model), 3);
    for (int k = 0; k < 3; k++) {
        const batten_mesh_parts *p = batten_mesh_view(batten_model_object(model, k)->mesh);
        int triangle = 0;
        CHECK_INT(p->vertex_count, k == 1 ? 3 : 4);
        CHECK_INT(p->triangle_count, k == 1 ? 1 : 2);
        for (int i = 0; i < p->vertex_count; i++)
            CHECK_BITS(p->points[3 * i], points[k][i]); /* x is the number of the point */
        for (int i = 0; i < COUNT(faces); i++)
            for (int c = 0; faces[i].layer == k && c < 3; c++, triangle += c == 3)
                CHECK_INT(points[k][p->corners[3 * triangle + c]], faces[i].corners[c]);
    }
    batten_model_unref(model);
}

TEST(F2_a_ship_cut_anywhere_is_refused)
{
    for (size_t length = 10; length < strlen(net) - 3; length++) {
        batten_model *model = NULL;
        CHECK(read_bytes(net, length, BATTEN_FORMAT_FTM, NULL, &model) != BATTEN_OK);
        CHECK(!model);
    }
}

TEST(S2_counts_beyond_the_lines_of_a_ship_are_refused)
{
    check_refused("FREE!ship\n2.6\n1000000000\n0 0 0\n1\n0\n0\n", BATTEN_FORMAT_AUTO,
                  BATTEN_BAD_FORMAT, "has no control points");
    check_refused("FREE!ship\n3\n0 0 0\n1\n0\n0\n0 0 0\n1\n0\n0\n0 0 0\n1\n0\n0\n900\n",
                  BATTEN_FORMAT_AUTO, BATTEN_BAD_FORMAT,
                  "t:15: the number of edges is not a whole number from 0 to 0");
}

TEST(published_ships_have_their_nets)
{
    static const struct {
        const char *path;
        int layers, triangles;
    } files[] = {{"hull_surfaces/windsurf_board.ftm", 3, 132},
                 {"hull_surfaces/motorboat.ftm", 4, 32}};
    for (int i = 0; i < COUNT(files); i++) {
        batten_model *model = NULL;
        int triangles = 0;
        CHECK_OK(batten_read_file(test_data(files[i].path), NULL, NULL, NULL, &model));
        CHECK_INT(batten_model_count(model), files[i].layers);
        for (int k = 0; k < batten_model_count(model); k++)
            triangles += batten_mesh_view(batten_model_object(model, k)->mesh)->triangle_count;
        CHECK_INT(triangles, files[i].triangles);
        batten_model_unref(model);
    }
}

TEST(N4_a_mark_of_a_crease_that_is_none_is_refused)
{
    static const char edge[] = "\n0\n0\n2\n0\n1\n";
    const char *found = strstr(net, edge);
    char text[sizeof net + 20];
    CHECK(found != NULL);
    const size_t at = (size_t)(found - net) + strlen(edge);
    snprintf(text, sizeof text, "%.*s2147483647%s", (int)at, net, net + at + 1);
    check_refused(text, BATTEN_FORMAT_FTM, BATTEN_BAD_FORMAT, "the mark of a crease");
}
