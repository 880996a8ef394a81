/* Faces of more than three corners become triangles, which readers say. */
#include "exchange/reading.h"

TEST(faces_of_more_than_three_corners_are_counted)
{
    static const char *const files[] = {
        "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 2 0\nf 1 2 3 4\nf 1 2 3 5 4\nf 1 2 "
        "3\n",
        "OFF\n5 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 2 0\n4 0 1 2 3\n5 0 1 2 4 3\n3 0 1 2\n",
        "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
        "property float z\nelement face 3\nproperty list uchar int vertex_indices\nend_header\n"
        "0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 2 0\n4 0 1 2 3\n5 0 1 2 4 3\n3 0 1 2\n"};
    for (int i = 0; i < COUNT(files); i++) {
        batten_notes *notes = NULL;
        batten_model *model = NULL;
        int said = 0;
        CHECK_OK(batten_notes_create(100, &notes));
        batten_status status = read_text(files[i], BATTEN_FORMAT_AUTO, notes, &model);
        if (test_memory_failed(status, BATTEN_OK)) { /* what it noted is of no account */
            batten_notes_free(notes);
            notes = NULL;
            CHECK_OK(batten_notes_create(100, &notes));
            status = read_text(files[i], BATTEN_FORMAT_AUTO, notes, &model);
        }
        CHECK_OK(status);
        for (int k = 0; k < batten_notes_count(notes); k++)
            said += strstr(batten_notes_at(notes, k)->text,
                           "faces of more than three corners: 2; read as triangles") != NULL;
        if (!batten_notes_dropped(notes))
            CHECK_INT(said, 1);
        batten_model_unref(model);
        batten_notes_free(notes);
    }
}

TEST(triangles_are_not_counted)
{
    batten_notes *notes = NULL;
    batten_model *model = NULL;
    CHECK_OK(batten_notes_create(100, &notes));
    CHECK_OK(
        read_text("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", BATTEN_FORMAT_OBJ, notes, &model));
    CHECK(!has_note(notes, "more than three corners"));
    batten_model_unref(model);
    batten_notes_free(notes);
}
