# SPDX-FileCopyrightText: 2026 The Index Boolean authors
# SPDX-License-Identifier: GPL-3.0-or-later
set(PACKAGE_VERSION 5.15)
set(PACKAGE_VERSION_COMPATIBLE TRUE)
