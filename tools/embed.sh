#!/bin/sh
# SPDX-License-Identifier: MIT
# Writes an assembly file that holds the given files, and the table that src/core/resources.cpp reads:
# pantin_resources = {name, begin, end}…, closed by a null name. Usage: tools/embed.sh [NAME=]FILE… > resources.S
set -eu
printf '#ifdef __LP64__\n#define ADDRESS .quad\n#else\n#define ADDRESS .long\n#endif\n    .section .rodata\n'
i=0
for file in "$@"; do
    printf '    .balign 64\nfile_%d:\n    .incbin "%s"\nfile_end_%d:\n    .byte 0\nname_%d:\n    .asciz "%s"\n' "$i" "${file#*=}" "$i" "$i" "${file%%=*}"
    i=$((i + 1))
done
printf '    .section .data.rel.ro,"aw"\n    .balign 8\n    .globl pantin_resources\npantin_resources:\n'
j=0
while [ "$j" -lt "$i" ]; do
    printf '    ADDRESS name_%d, file_%d, file_end_%d\n' "$j" "$j" "$j"
    j=$((j + 1))
done
printf '    ADDRESS 0, 0, 0\n    .section .note.GNU-stack,"",%%progbits\n'
