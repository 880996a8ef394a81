/* What is said of tables of offsets, to the letter and the line. */
#include "exchange/listed.h"

static const struct {
    const char *text;
    batten_status status;
    const char *listing;
} tables[] = {
    {"x,z,half-breadth\n0,0,1\n0,1,2\n2,0,1\n2,1,2\n", BATTEN_OK, ""},
    {"x,z,half-breadth\n2,0,1\n2,1,1\n0,0,\n0,1,-\n", BATTEN_OK,
     "4: station x = 0 has no points; left out\n"
     "0: the stations do not come in the order of x; sorted\n"},
    {"x,z,half-breadth\n0,0,-1\n0,1,2\n2,0,-1\n2,1,2\n", BATTEN_OK,
     "2: 2 half-breadths are below 0, here the first; they are kept as they are\n"},
    {"x,z,half-breadth\n0,0,1\n0,1,-2\n", BATTEN_OK,
     "3: 1 half-breadth is below 0, here the first; it is kept as it is\n"},
    {"x,z,half-breadth,girth\n0,0,1,7\n0,1,2,8\n", BATTEN_OK,
     "1: column 'girth' is not read\n"},
    {"x,z,half-breadth\n0,0,\n", BATTEN_BAD_FORMAT,
     "2: station x = 0 has no points; left out\nt: there is no point in the table\n"},
    /* frames of PIAS, whose third number is a mark, and sections of PDSTRIP */
    {"1\n0.0\n2\n0 0 0\n1 1 0\n", BATTEN_OK, ""},
    {"1\n0.0\n3\n0 0 1\n1 1 0\n2 3 0\n", BATTEN_OK,
     "~0: 1 point is marked; tables of offsets have no marks\n"},
    {"1\n0.0\n3\n0 0 1\n1 1 0\n2 3 1\n", BATTEN_OK,
     "~0: 2 points are marked; tables of offsets have no marks\n"},
    {"1 F 0.96\n 0.0 3 1 2\n 0 1 2\n 0 1 3\n", BATTEN_OK,
     "4: section 1 has 1 gap; its points are taken as one line\n"},
    {"1 F 0.96\n 0.0 3 2 1 2\n 0 1 2\n 0 1 3\n", BATTEN_OK,
     "4: section 1 has 2 gaps; its points are taken as one line\n"},
    /* the loftsman's table */
    {"Stations,a,b\nPOSITION,,\nk,0,9\nHEIGHT,,\nk,1,2\nBREADTH,,\nk,3,4\n", BATTEN_OK, ""},
    {"Stations,a,b\nPOSITION,,\nk,0,9\nHEIGHT,,\nk,1,2\nm,x,2\nBREADTH,,\nk,3,x\nn,3,3\n",
     BATTEN_OK,
     "5: k: stations that have a height and no breadth: 1; these points are left out\n"
     "6: m: stations that have a height and no breadth: 1; these points are left out\n"
     "9: n: stations that have a breadth and no height: 2; these points are left out\n"},
    {"Stations,a,b\nPOSITION,,\nk,0,9\nHEIGHT,,\nk,1,2\nBREADTH,,\nk,3,4\nDIAGONALS,,\nA,1,1\n",
     BATTEN_OK,
     "0: 1 row is of diagonals and other blocks left out: only positions, heights and breadths "
     "are read\n"},
    {"Stations,a,b\nPOSITION,,\nk,0,9\nHEIGHT,,\nk,1,2\nBREADTH,,\nk,3,4\nDIAGONALS,,\nA,1,1\n"
     "B,1,2\n",
     BATTEN_OK,
     "0: 2 rows are of diagonals and other blocks left out: only positions, heights and breadths "
     "are read\n"},
};

TEST(what_is_wrong_in_a_table_of_offsets_is_named_with_its_line)
{
    for (int i = 0; i < COUNT(tables); i++)
        check_listed(tables[i].text, BATTEN_FORMAT_OFFSET_TABLE, tables[i].status,
                     tables[i].listing);
}
