#!/bin/sed -f
# A header begins with plain comments that say what it is for: they document the file.
1,/^[^/]/{
  s|^//|///|
  s|^#pragma once$|/// @file|
}
