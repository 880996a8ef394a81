/* Entities decoded: moved by their matrices, and used by others as what they are. */
#include "exchange/iges/faces.h"

static const char part[] = "00010000", root[] = "00000000";
/* A quarter turn about x and a move: (x, y, z) becomes (x + 1, -z + 2, y + 3). */
static const char turn[] = "124,1.,0.,0.,1.,0.,0.,-1.,2.,0.,1.,0.,3.;";

TEST(all_points_of_a_set_are_moved_by_its_matrix)
{
    iges_text file = iges_begin();
    iges_add(&file, 106, 2, 3, 0, root, "106,2,3,0.,0.,0.,1.,2.,3.,-4.,5.,-6.;");
    iges_add(&file, 124, 0, 0, 0, root, turn);
    batten_model *model = read_noting(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, "");
    static const double moved[9] = {1, 2, 3, 2, -1, 5, -3, 8, 8};
    CHECK_INT(batten_model_object(model, 0)->point_count, 3);
    for (int i = 0; i < 9; i++)
        CHECK_BITS(batten_model_object(model, 0)->points[i], moved[i]);
    batten_model_unref(model);
}

/* Curve, surface, body and composite: the corner at (4, 4, 0) comes to (5, 2, 7). */
TEST(a_matrix_moves_what_is_made_of_any_kind)
{
    static const struct {
        int type;
        const char *parameters;
    } cases[] = {{110, "110,0.,0.,0.,4.,4.,0.;"},
                 {102, "102,2,5,7;"},
                 {128, IGES_SQUARE},
                 {144, "144,9,0,0,;"}};
    for (int i = 0; i < COUNT(cases); i++) {
        iges_text file = iges_begin();
        batten_box box;
        iges_add(&file, 124, 0, 0, 0, root, turn);
        iges_add(&file, 124, 0, 0, 0, root, turn);
        iges_add(&file, 110, 0, 0, 0, part, "110,0.,0.,0.,4.,0.,0.;");
        iges_add(&file, 110, 0, 0, 0, part, "110,4.,0.,0.,4.,4.,0.;");
        iges_add(&file, 128, 0, 0, 0, part, IGES_SQUARE);
        iges_add(&file, cases[i].type, 0, 3, 0, root, cases[i].parameters);
        batten_model *model = NULL;
        CHECK_OK(read_text(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, NULL, &model));
        batten_model *last = NULL;
        CHECK_OK(batten_model_create(1, &last));
        CHECK_OK(
            batten_model_add(last, batten_model_object(model, batten_model_count(model) - 1)));
        CHECK(batten_model_box(last, &box));
        CHECK_BITS(box.low.x, 1.0);
        CHECK_BITS(box.low.z, 3.0);
        CHECK_BITS(box.high.x, 5.0);
        CHECK_BITS(box.high.y, 2.0);
        CHECK_BITS(box.low.y, 2.0);
        CHECK_BITS(box.high.z, 7.0);
        batten_model_unref(last);
        batten_model_unref(model);
    }
}

TEST(what_others_refer_to_is_of_the_kind_that_they_need)
{
    static const struct {
        int type;
        const char *parameters, *words;
    } cases[] = {
        {140, "140,0.,0.,1.,.5,1;", "it refers to entity D1 as a surface, which is a 110 line"},
        {140, "140,0.,0.,1.,.5,9;", "entity D9 is a face, not a surface"},
        {122, "122,3,1.,1.,1.;",
         "it refers to entity D3 as a curve, which is a 128 B-spline surface"},
        {122, "122,5,1.,1.,1.;", "entity D5 is a set of points, not a curve"},
        {122, "122,99,1.,1.,1.;", "it refers to entity D99, which is missing"},
        {122, "122,11,1.,1.,1.;", "an arc of radius 0"},
        {118, "118,1,13,0,0;",
         "it refers to entity D13 as a curve, which is a 777, an unknown type"},
    };
    for (int i = 0; i < COUNT(cases); i++) {
        iges_text file = iges_begin();
        iges_add(&file, 110, 0, 0, 0, part, "110,0.,0.,0.,4.,0.,0.;");         /* 1 */
        iges_add(&file, 128, 0, 0, 0, part, IGES_SQUARE);                      /* 3 */
        iges_add(&file, 106, 2, 0, 0, part, "106,2,1,0.,0.,0.;");              /* 5 */
        iges_add(&file, 100, 0, 0, 0, part, "100,0.,2.,2.,3.,2.,3.,2.;");      /* 7 */
        iges_add(&file, 108, 1, 0, 0, part, "108,0.,0.,1.,0.,7,0.,0.,0.,1.;"); /* 9 */
        iges_add(&file, 100, 0, 0, 0, part, "100,0.,2.,2.,2.,2.,3.,2.;");      /* 11 */
        iges_add(&file, 777, 0, 0, 0, part, "777,1;");                         /* 13 */
        iges_add(&file, cases[i].type, 0, 0, 0, root, cases[i].parameters);
        iges_add(&file, 116, 0, 0, 0, root, "116,1.,2.,3.;");
        iges_check_partly(&file, cases[i].words);
    }
}

/* What cannot be read is read once, and whoever else refers to it learns that. */
TEST(what_cannot_be_read_leaves_out_all_that_refer_to_it)
{
    iges_text file = iges_begin();
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    iges_add(&file, 100, 0, 0, 0, part, "100,0.,2.,2.,2.,2.,3.,2.;");
    iges_add(&file, 122, 0, 0, 0, root, "122,1,1.,1.,1.;");
    iges_add(&file, 122, 0, 0, 0, root, "122,1,2.,2.,2.;");
    iges_add(&file, 116, 0, 0, 0, root, "116,1.,2.,3.;");
    CHECK_OK(batten_notes_create(20, &notes));
    CHECK_STATUS(read_text(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, notes, &model),
                 BATTEN_PARTLY_READ);
    CHECK_MESSAGE("2 of 3 entities are left out");
    if (!batten_notes_dropped(notes)) {
        CHECK(has_note(notes, "an arc of radius 0; left out"));
        CHECK(has_note(notes, "it refers to entity D1, which cannot be read; left out"));
    }
    batten_notes_free(notes);
    batten_model_unref(model);
}

/* A member of a definition is decoded whatever its type; one that is not read costs itself. */
TEST(members_of_a_definition_that_are_not_read_are_left_out)
{
    iges_text file = iges_begin();
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    iges_add(&file, 408, 0, 0, 0, root, "408,3,0.,0.,0.,1.;");
    iges_add(&file, 308, 0, 0, 0, "00000200", "308,0,1Ha,4,5,7,9,11;");
    iges_add(&file, 150, 0, 0, 0, part, "150,1.,2.,3.;");
    iges_add(&file, 314, 0, 0, 0, "00000200", "314,0.,0.,0.;");
    iges_add(&file, 126, 7, 0, 0, part, IGES_CURVE);
    iges_add(&file, 110, 0, 0, 0, part, IGES_LINE);
    CHECK_OK(batten_notes_create(20, &notes));
    CHECK_STATUS(read_text(iges_end(&file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, notes, &model),
                 BATTEN_PARTLY_READ);
    CHECK_MESSAGE("2 of 3 entities are left out");
    CHECK_INT(batten_model_count(batten_model_object(model, 0)->definition), 1);
    if (!batten_notes_dropped(notes)) {
        CHECK(has_note(notes, "entities of this type are not read; left out"));
        CHECK(has_note(notes, "its form 7 is not read; left out"));
    }
    batten_notes_free(notes);
    batten_model_unref(model);
}
