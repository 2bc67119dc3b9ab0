/* Solves a case file and prints the result as JSON.
 *
 *   cc solve_case.c $(pkg-config --cflags --libs microslip_c) -o solve_case
 *   ./solve_case hertzian_contact.toml
 */
#include <microslip.h>

#include <stdio.h>
#include <stdlib.h>

/* The whole file as a text; NULL if it cannot be read. */
static char* text_of(const char* path) {
  enum { longest = 1 << 20 };
  FILE* file = fopen(path, "rb");
  char* text = malloc(longest + 1);
  size_t length = 0;
  if (file && text) length = fread(text, 1, longest, file);
  if (text) text[length] = 0;
  if (!file) {
    free(text);
    return NULL;
  }
  fclose(file);
  return text;
}

int main(int count, char** arguments) {
  char *text, *json = NULL;
  microslip_error error;
  int code;
  if (count != 2 || !(text = text_of(arguments[1]))) {
    fprintf(stderr, "usage: solve_case CASE.toml\n");
    return 2;
  }
  code = microslip_solve_case(text, arguments[1], &json, &error);
  if (json) printf("%s", json);
  if (code != MICROSLIP_OK) fprintf(stderr, "%s (%s)\n", error.text, microslip_code_text(code));
  microslip_free_text(json);
  free(text);
  return code == MICROSLIP_OK ? 0 : 1;
}
