/* What is written of points, names and splines, as text. */
#include "exchange/reading.h"
#include "exchange/shapes/paths.h"

static batten_model *model_of_rows(int count)
{
    static const double points[] = {1, 2, 3, 4, 5, 6};
    batten_model *model = NULL;
    CHECK_OK(batten_model_create(1, &model));
    for (int i = 0; i < count; i++)
        CHECK_OK(batten_model_add(model, &(batten_object){.name = i ? "aft" : "row",
                                                          .kind = BATTEN_OBJECT_POINTS,
                                                          .point_count = 2,
                                                          .points = points}));
    return model;
}

TEST(every_point_of_a_row_is_an_entity_on_the_layer_of_its_name)
{
    batten_model *model = model_of_rows(1);
    const char *text = written(model, BATTEN_FORMAT_DXF);
    const char *first = strstr(text, "\n  0\nPOINT\n");
    CHECK(first != NULL);
    CHECK_CONTAINS(first, "  8\nrow\n");
    CHECK_CONTAINS(first, " 10\n1\n 20\n2\n 30\n3\n  0\nPOINT\n");
    CHECK_CONTAINS(first, " 10\n4\n 20\n5\n 30\n6\n  0\nENDSEC\n");
    batten_model_unref(model);
}

TEST(dxf_remarks_how_many_names_become_layers)
{
    static const char *const words[] = {
        "1 object without a layer is on a layer of that name",
        "2 objects without a layer are on a layer of that name"};
    batten_write_options options = batten_write_defaults();
    options.format = BATTEN_FORMAT_DXF;
    for (int k = 0; k < 2; k++) {
        batten_model *model = model_of_rows(k + 1);
        batten_notes *notes = NULL;
        char *data = NULL;
        size_t size = 0;
        CHECK_OK(batten_notes_create(10, &notes));
        CHECK_OK(batten_write_memory(model, &options, notes, &data, &size));
        CHECK(batten_notes_dropped(notes) || has_note(notes, words[k]));
        batten_release(data);
        batten_notes_free(notes);
        batten_model_unref(model);
    }
}

TEST(a_spline_announces_its_knots_its_points_and_none_to_pass_through)
{
    const double points[] = {0, 0, 1, 3, 4, -1, 6, 2, 9, 0};
    batten_curve *curve = NULL;
    CHECK_OK(batten_curve_interpolate((batten_points){2, 5, points}, NULL, NULL, &curve));
    batten_model *model = model_of_curve(curve, "sheer");
    CHECK_CONTAINS(written(model, BATTEN_FORMAT_DXF),
                   " 70\n0\n 71\n3\n 72\n9\n 73\n5\n 74\n0\n 40\n0\n");
    batten_model_unref(model);
}
