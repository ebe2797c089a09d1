// SPDX-License-Identifier: MIT
// stb_image and stb_image_write (Sean Barrett, public domain) with only what Pantin uses: PNG and JPEG from
// memory, PNG to memory. Without SIMD, because the SIMD inverse DCT of a JPEG may round differently from the
// scalar one.
#pragma once

#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_SIMD
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#define STBI_MAX_DIMENSIONS 16384

#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
