/*
 * The 80-column records of an IGES file, its global parameters, its directory, and the
 * parameters of an entity. What they mean is for entities.c.
 */
#ifndef BAT_IGES_RECORDS_H
#define BAT_IGES_RECORDS_H
#include "exchange/iges/parameters.h"

/* An entry of the directory. */
typedef struct {
    int id;                                         /* the odd number of its first record */
    int type, form, data, level, transform, colour; /* as they stand in its fields */
    int hidden, subordinate, use;                   /* of its status */
    int subscript;
    char label[9];
    int line;       /* of the file */
    bool is_broken; /* a field could not be read */
} bat_iges_entry;

/* A record of the parameter section. */
typedef struct {
    size_t at;  /* where it stands in the file */
    int number; /* its sequence number, or its place when the numbers are no good */
    int line;
    unsigned char columns; /* how many of its first 64 it has */
    bool is_damaged;
} bat_iges_data;

typedef struct {
    bat_input *input;
    bat_iges_delimiters delimiters;
    bat_iges_parameters global; /* those from the third on */
    bat_list directory;         /* the records of the directory */
    bat_list entries;           /* of bat_iges_entry, with rising ids */
    bat_list data;              /* of bat_iges_data */
    size_t tokenised;           /* characters that were gone through so far */
    bool has_start, has_end;
    char next[7]; /* while records are read: the last sequence number as text, and as such */
    int number;
} bat_iges_file;

/* Take the file apart. */
batten_status bat_iges_begin(bat_input *input, bat_iges_file *file);
void bat_iges_end(bat_iges_file *file);
batten_status bat_iges_global(bat_iges_file *file);
/* The parameters of an entry, its type first. BAD_FORMAT, with a message for a note, when they
 * cannot be told apart. */
batten_status bat_iges_read_parameters(bat_iges_file *file, const bat_iges_entry *entry,
                                       bat_iges_parameters *parameters);

#endif
