/* Which texts are recognised as OBJ by what stands in them. */
#include "exchange/reading.h"

static const struct {
    const char *text;
    bool is_obj;
} texts[] = {
    {"v 1 2 3\n", true},
    {"# a comment\nmtllib a.mtl\no hull\nv 1 2 3\nv 0 0 0\n", true},
    {"newmtl red\nKd 1 0 0\nv 1 2 3\n", true},
    {"vn 0 0 1\nv 1 2 3\n", true},
    {"v 1 x\nv 0 0 0\n", false},
    {"v x 1\nv 0 0 0\n", false},
    {"v 1\n2 3\n", false},
    {"v\nv 1 2 3\n", false},
    {"hull\nv 1 2 3\n", false},
    {"# a comment alone\n", false},
    {"o hull\n", false},
};

TEST(an_obj_file_is_known_by_a_vertex_of_two_numbers_before_any_strange_word)
{
    for (int k = 0; k < COUNT(texts); k++) {
        batten_model *model = NULL;
        if (!texts[k].is_obj) {
            check_refused(texts[k].text, BATTEN_FORMAT_AUTO, BATTEN_BAD_FORMAT,
                          "t: ");
            continue;
        }
        CHECK_OK(read_text(texts[k].text, BATTEN_FORMAT_AUTO, NULL, &model));
        CHECK_INT(batten_model_object(model, 0)->kind, BATTEN_OBJECT_POINTS);
        batten_model_unref(model);
    }
}
