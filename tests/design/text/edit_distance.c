#include "design/text/edit_distance.h"

#include "support/generate.h"
#include "support/test.h"

#include <string.h>

TEST(edit_distance_counts_letters)
{
    CHECK_INT(bat_edit_distance("skin", "skin", 9), 0);
    CHECK_INT(bat_edit_distance("skim", "skin", 9), 1);
    CHECK_INT(bat_edit_distance("sikn", "skin", 9), 1);
    CHECK_INT(bat_edit_distance("skn", "skin", 9), 1);
    CHECK_INT(bat_edit_distance("kitten", "sitting", 9), 3);
    CHECK_INT(bat_edit_distance("abc", "xyzuvw", 4), 4);
}

static void draw_word(test_random *random, char word[12])
{
    const int length = test_random_int(random, 0, 11);
    for (int i = 0; i < length; i++)
        word[i] = (char)('a' + test_random_int(random, 0, 3));
    word[length] = 0;
}

TEST(edit_distance_is_that_of_the_rests_behind_a_common_start)
{
    test_random random = test_random_begin("spelling");
    for (int k = 0; k < 500; k++) {
        char a[12], b[12], longer_a[16] = "xyz", longer_b[16] = "xyz";
        draw_word(&random, a);
        draw_word(&random, b);
        strcat(longer_a, a);
        strcat(longer_b, b);
        const int d = bat_edit_distance(a, b, 99);
        CHECK_INT(bat_edit_distance(b, a, 99), d);
        CHECK_INT(bat_edit_distance(longer_a, longer_b, 99), d);
        CHECK((d == 0) == (strcmp(a, b) == 0));
        const int m = (int)strlen(a), n = (int)strlen(b);
        CHECK(d <= (m > n ? m : n) && d >= (m > n ? m - n : n - m));
        CHECK_INT(bat_edit_distance(a, b, d), d);
        CHECK_INT(bat_edit_distance(a, b, d + 1), d);
    }
}

TEST(names_too_long_to_be_compared_are_far_from_all)
{
    char word[64];
    memset(word, 'a', 49);
    word[49] = 0;
    CHECK_INT(bat_edit_distance(word, word, 7), 7);
    word[48] = 0;
    CHECK_INT(bat_edit_distance(word, word, 7), 0);
}
