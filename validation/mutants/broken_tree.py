# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A copy of the project, with what is built, to break, rebuild and test."""

import functools
import glob
import os
import shutil
import subprocess

BUILT = "src/*/Make/linux*", "src/*/lnInclude", "applications/*/*/Make/linux*", \
    "platforms/linux*"


@functools.lru_cache
def sources(root):
    """What belongs to the project: known to git, or all without it."""
    listed = subprocess.run(["git", "ls-files", "-co", "--exclude-standard"], cwd=root,
                            capture_output=True, text=True)
    if listed.returncode == 0 and listed.stdout:
        names = listed.stdout.splitlines()
    else:
        names = [os.path.relpath(os.path.join(folder, name), root)
                 for folder, _, files in os.walk(root) for name in files
                 if not os.path.relpath(folder, root).startswith(("platforms", "."))]
    return sorted(name for name in names if os.path.isfile(os.path.join(root, name))
                  and not name.startswith(("validation/mutants/", ".")))


class BrokenTree:
    def __init__(self, root, scratch):
        self.root, self.path = root, scratch
        shutil.rmtree(scratch, ignore_errors=True)
        os.makedirs(scratch)
        # a copy of its own: a linker may write through hard links
        names = sources(root) + [
            os.path.relpath(path, root)
            for pattern in BUILT for path in glob.glob(os.path.join(root, pattern))]
        with subprocess.Popen(["tar", "-C", root, "-cf", "-", "-T", "-"], stdin=subprocess.PIPE,
                              stdout=subprocess.PIPE, text=True) as pack:
            with subprocess.Popen(["tar", "-C", scratch, "-xf", "-"], stdin=pack.stdout) as unpack:
                pack.stdin.write("\n".join(names) + "\n")
                pack.stdin.close()
                unpack.wait()
            if pack.wait() or unpack.returncode:
                raise RuntimeError(f"{root} could not be copied to {scratch}")

    def _shell(self, script):
        return subprocess.run(
            ["bash", "-c", ". etc/bashrc && " + script], cwd=self.path,
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def _builds(self, file):
        """Folder of a file of the code, if it has to be built."""
        if file.endswith(".C"):
            return "/".join(file.split("/")[:2 if file.startswith("src/") else 3])
        if file.startswith(("src/", "applications/")):
            raise ValueError(f"{file}: change a .C file, others would be built with a header")
        return None

    def broken(self, mutant):
        """With the mutant in place, built; whole again at the end of a `with`."""
        return Broken(self, mutant, self._builds(mutant.file))

    def build(self, folder):
        kind = "libso" if folder.startswith("src/") else ""
        # as Allwmake: tests by themselves, others with their sources joined, all
        # of them, as what each part depends on is noted with places of the original
        joined = f"platforms/$WM_OPTIONS/joined/{folder}"
        made = self._shell(
            f"wmake -s {kind} {folder}" if folder.startswith("applications/test/") else
            f"touch {joined}/*.C && wmake -s {kind} {joined}")
        if made.returncode:
            raise RuntimeError(f"{folder} does not compile:\n{made.stdout[-3000:]}")

    def test(self, names, seconds=None, tell=None):
        """Output of these tests; tell gets its lines as they come. None if it
        took too long."""
        environment = dict(os.environ, FSBI_NO_BUILD="1")
        environment.pop("FSBI_DIR", None)
        run = subprocess.Popen(["bash", "validation/Alltest", *names], cwd=self.path,
                               env=environment, stdin=subprocess.DEVNULL,
                               stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        try:
            if tell:
                for line in run.stdout:
                    tell(line.rstrip("\n"))
            output, _ = run.communicate(timeout=seconds)
            return output
        except subprocess.TimeoutExpired:
            return None
        finally:
            if run.poll() is None:
                run.terminate()         # it ends what it has started
                run.communicate()


class Broken:
    def __init__(self, tree, mutant, folder):
        self.tree, self.mutant, self.folder = tree, mutant, folder
        self.kept = tree.path + ".kept"

    def _parts(self):
        """What a build of the folder changes, and the file itself."""
        yield self.mutant.file
        if self.folder:
            for pattern in (f"{self.folder}/Make/linux*", "platforms/linux*"):
                for path in glob.glob(os.path.join(self.tree.path, pattern)):
                    yield os.path.relpath(path, self.tree.path)

    def _copy(self, source, target):
        for part in self._parts():
            one, other = os.path.join(source, part), os.path.join(target, part)
            if os.path.isdir(one):
                shutil.rmtree(other, ignore_errors=True)
                shutil.copytree(one, other, symlinks=True)
            else:
                os.makedirs(os.path.dirname(other), exist_ok=True)
                shutil.copy2(one, other)

    def __enter__(self):
        text = self.mutant.applied(self.tree.path)
        shutil.rmtree(self.kept, ignore_errors=True)
        self._copy(self.tree.path, self.kept)
        with open(os.path.join(self.tree.path, self.mutant.file), "w") as file:
            file.write(text)
        if self.folder:
            self.tree.build(self.folder)
        return self

    def __exit__(self, *_):
        self._copy(self.kept, self.tree.path)
        shutil.rmtree(self.kept)
