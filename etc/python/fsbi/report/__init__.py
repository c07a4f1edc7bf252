# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""One page of a run: what it was, what it did, what it cost; see fsbiReport."""
