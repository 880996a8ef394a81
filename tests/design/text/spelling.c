#include "design/text/spelling.h"

#include "support/test.h"

TEST(the_nearest_of_known_names_is_meant)
{
    int best = 99;
    CHECK(!bat_is_nearer("x", "y", &best));
    CHECK(bat_is_nearer("degre", "degree", &best) && best == 1);
    CHECK(!bat_is_nearer("degre", "decree", &best));
}

TEST(a_third_of_the_letters_may_be_wrong_and_never_all)
{
    static const struct {
        const char *word, *known;
        bool is_near;
    } rows[] = {{"a", "b", false},
                {"ab", "ac", true},
                {"ab", "cd", false},
                {"abcde", "abcxy", false},
                {"abcdef", "abcdxy", true},
                {"abcdefgh", "abcdexyz", false},
                {"abcdefghi", "abcdefxyz", true}};
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; i++) {
        int best = 99;
        CHECK_INT(bat_is_nearer(rows[i].word, rows[i].known, &best), rows[i].is_near);
        CHECK(rows[i].is_near == (best < 99));
    }
    int best = 99;
    CHECK(bat_is_nearer("interpolate", "interpolat", &best));
    CHECK_INT(best, 1);
    CHECK(!bat_is_nearer("interpolate", "nterpolate", &best)); /* the first of equals stays */
    CHECK(bat_is_nearer("interpolate", "interpolate", &best));
}
