/* How notes on a body name its faces. */
#include "body/check/parts.h"
#include "support/test.h"

/* Faces count from 1; of several bodies in one they have the numbers that they had. */
TEST(a_face_is_named_by_its_number_and_the_name_that_it_was_given)
{
    static const batten_body_face faces[] = {{.name = "bottom"}, {.name = ""}, {.name = "top"}};
    static const int numbers[] = {2, 1};
    const batten_body_parts named = {.face_count = 3, .faces = faces};
    bat_check check = {.named = &named};
    char name[BAT_CHECK_NAME];
    CHECK(bat_check_face_name(&check, 0, name) == name);
    CHECK_TEXT(name, "face 1 \"bottom\"");
    CHECK_TEXT(bat_check_face_name(&check, 1, name), "face 2");
    CHECK_TEXT(bat_check_face_name(&check, 2, name), "face 3 \"top\"");
    check.numbers = numbers;
    CHECK_TEXT(bat_check_face_name(&check, 0, name), "face 3 \"top\"");
    CHECK_TEXT(bat_check_face_name(&check, 1, name), "face 2");
}

TEST(a_long_name_is_cut_to_64_letters)
{
    char given[101], name[BAT_CHECK_NAME], due[BAT_CHECK_NAME];
    memset(given, 'x', 100);
    given[100] = '\0';
    const batten_body_face face = {.name = given};
    const batten_body_parts named = {.face_count = 1, .faces = &face};
    const bat_check check = {.named = &named};
    snprintf(due, sizeof due, "face 1 \"%.64s\"", given);
    CHECK_TEXT(bat_check_face_name(&check, 0, name), due);
}
