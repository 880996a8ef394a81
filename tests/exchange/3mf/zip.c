/* Archives of stored members. */
#include "exchange/3mf/3mf.h"
#include "support/test.h"

TEST(a_zip_archive_is_written_so)
{
    static const char expected[] =
        "PK\3\4\x0a\0\0\0\0\0\0\0\x21\0\x26\x39\xf4\xcb\x09\0\0\0\x09\0\0\0\x01\0\0\0a123456789"
        "PK\1\2\x0a\0\x0a\0\0\0\0\0\0\0\x21\0\x26\x39\xf4\xcb\x09\0\0\0\x09\0\0\0\x01\0\0\0\0\0"
        "\0\0\0\0\0\0\0\0\0\0\0\0a"
        "PK\5\6\0\0\0\0\1\0\1\0\x2f\0\0\0\x28\0\0\0\0";
    batten_text text = BATTEN_TEXT;
    CHECK_OK(bat_zip(1, &(bat_zip_member){"a", "123456789", 9}, &text));
    if (!text.failed) {
        CHECK_INT((long long)text.length, (long long)sizeof expected);
        CHECK(memcmp(text.bytes, expected, sizeof expected) == 0);
    }
    batten_text_free(&text);
}
