/* A zip archive of stored files, without compression. */
#include "exchange/3mf/3mf.h"
#include "exchange/reading/bytes.h"

/* CRC-32; that of "123456789" is cbf43926. */
static uint32_t checksum_of(const char *bytes, size_t length)
{
    uint32_t table[256], crc = 0xffffffffu;
    for (uint32_t i = 0; i < 256; i++) {
        table[i] = i;
        for (int k = 0; k < 8; k++)
            table[i] = table[i] & 1 ? table[i] >> 1 ^ 0xedb88320u : table[i] >> 1;
    }
    for (size_t i = 0; i < length; i++)
        crc = table[(crc ^ (unsigned char)bytes[i]) & 0xff] ^ crc >> 8;
    return ~crc;
}

/* From the version that is needed to the length of the extra field, which both headers have. */
static void put_description(const bat_zip_member *member, uint32_t crc, batten_text *text)
{
    bat_bytes_put(text, 10, 2);     /* version 1.0 reads it */
    bat_bytes_put(text, 0, 2);      /* flags */
    bat_bytes_put(text, 0, 2);      /* stored */
    bat_bytes_put(text, 0, 2);      /* midnight */
    bat_bytes_put(text, 0x0021, 2); /* 1 January 1980 */
    bat_bytes_put(text, crc, 4);
    bat_bytes_put(text, member->length, 4);
    bat_bytes_put(text, member->length, 4);
    bat_bytes_put(text, strlen(member->name), 2);
    bat_bytes_put(text, 0, 2);
}

static void put_central(const bat_zip_member *member, uint32_t crc, size_t at,
                        batten_text *text)
{
    batten_text_bytes(text, "PK\1\2", 4);
    bat_bytes_put(text, 10, 2); /* made by version 1.0 */
    put_description(member, crc, text);
    bat_bytes_put(text, 0, 2); /* comment */
    bat_bytes_put(text, 0, 2); /* disk */
    bat_bytes_put(text, 0, 2); /* attributes */
    bat_bytes_put(text, 0, 4);
    bat_bytes_put(text, at, 4);
    batten_text_bytes(text, member->name, strlen(member->name));
}

batten_status bat_zip(int count, const bat_zip_member *members, batten_text *text)
{
    batten_text central = BATTEN_TEXT;
    double sum = 0;
    for (int i = 0; i < count; i++)
        sum += (double)members[i].length + 1024;
    if (sum > (double)UINT32_MAX)
        return bat_fail(BATTEN_TOO_LARGE, "a zip archive of %.0f bytes; it can have 4 GiB",
                        sum);
    for (int i = 0; i < count; i++) {
        const uint32_t crc = checksum_of(members[i].bytes, members[i].length);
        put_central(&members[i], crc, text->length, &central);
        batten_text_bytes(text, "PK\3\4", 4);
        put_description(&members[i], crc, text);
        batten_text_bytes(text, members[i].name, strlen(members[i].name));
        batten_text_bytes(text, members[i].bytes, members[i].length);
    }
    const size_t at = text->length, length = central.length;
    text->failed = text->failed || central.failed;
    batten_text_bytes(text, central.bytes, length);
    batten_text_bytes(text, "PK\5\6\0\0\0\0", 8);
    bat_bytes_put(text, (uint64_t)count, 2);
    bat_bytes_put(text, (uint64_t)count, 2);
    bat_bytes_put(text, length, 4);
    bat_bytes_put(text, at, 4);
    bat_bytes_put(text, 0, 2);
    batten_text_free(&central);
    return BATTEN_OK;
}
