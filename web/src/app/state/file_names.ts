/// Files as they come from people, as files of a job: plain names, each once, and only those that can be read.

export interface PickedFile {
  readonly file: File;
  /// With its folders, "parts/left/bracket.stl".
  readonly path: string;
}

export interface NamedFile {
  readonly file: File;
  readonly name: string;
}

export interface RefusedFile {
  readonly file: string;
  readonly error: string;
}

const readable = /\.(stl|3mf|obj|ply|off|csv|json)$/i;
const drawings: Readonly<Record<string, string>> = {
  step: "STEP",
  stp: "STEP",
  iges: "IGES",
  igs: "IGES",
  sldprt: "SolidWorks",
  ipt: "Inventor",
  f3d: "Fusion",
  x_t: "Parasolid",
  x_b: "Parasolid",
  sat: "ACIS",
  "3dm": "Rhino",
  fcstd: "FreeCAD",
  amf: "AMF",
  glb: "glTF",
  gltf: "glTF",
  dae: "Collada",
  fbx: "FBX",
  blend: "Blender",
};

/// `folder`: they come from a folder, in which other files than meshes are passed over without a word.
export function nameFiles(
  picked: readonly PickedFile[],
  most: number,
): { readonly files: NamedFile[]; readonly refused: RefusedFile[] } {
  const files: NamedFile[] = [];
  const refused: RefusedFile[] = [];
  const taken = new Set<string>();
  for (const { file, path } of picked) {
    const folders = path.split("/");
    const own = folders.pop() ?? path;
    if (own.startsWith(".")) continue;
    if (!readable.test(own)) {
      const why = refusal(own, folders.length > 0);
      if (why) refused.push({ file: own, error: why });
      continue;
    }
    if (file.size > most) {
      refused.push({
        file: own,
        error: `The file is larger than this server takes. Make it coarser, or raise the limit.`,
      });
      continue;
    }
    const name = freeName(plainName(own), folders, taken);
    taken.add(name);
    files.push({ file, name });
  }
  return { files, refused };
}

function refusal(name: string, inFolder: boolean): string | null {
  const ending = name.split(".").pop()?.toLowerCase() ?? "";
  const kind = drawings[ending];
  if (kind) return `${kind} files are not read. Export it as 3MF or STL.`;
  return inFolder ? null : "Files of this kind are not read. STL, 3MF, OBJ, PLY and OFF are.";
}

/// No control characters, nothing that a path is made of, at most 200 characters, of which the last keep the ending.
function plainName(name: string): string {
  // biome-ignore lint/suspicious/noControlCharactersInRegex: they are what is taken out.
  const plain = name.replace(/[\u0000-\u001f\u007f/\\]/g, "_");
  return plain.length <= 160 ? plain : plain.slice(0, 100) + plain.slice(-60);
}

/// Files of one name in several folders have their folder's name before theirs.
function freeName(name: string, folders: readonly string[], taken: ReadonlySet<string>): string {
  let free = name;
  for (let depth = folders.length - 1; depth >= 0 && taken.has(free); depth -= 1) {
    free = plainName(`${folders.slice(depth).join("-")}-${name}`);
  }
  for (let number = 2; taken.has(free); number += 1) free = name.replace(/(\.[^.]*)$/, `-${number}$1`);
  return free;
}

/// What a new job is called: its folder, its job or set file, its only part; else when it was made.
export function jobName(picked: readonly PickedFile[], now: Date): string {
  const folder = picked.map(({ path }) => (path.includes("/") ? path.split("/")[0] : "")).find((name) => name);
  if (folder) return shortName(folder);
  const stem = (name: string) => name.replace(/\.[^.]*$/, "");
  const plan = picked.find(({ file }) => /\.(csv|json)$/i.test(file.name));
  const named = plan ?? (picked.length === 1 ? picked[0] : undefined);
  if (named) return shortName(stem(named.file.name)) || "Build";
  const two = (value: number) => value.toString().padStart(2, "0");
  const date = `${now.getFullYear()}-${two(now.getMonth() + 1)}-${two(now.getDate())}`;
  return `Build ${date} ${two(now.getHours())}:${two(now.getMinutes())}`;
}

/// A job's name has at most 100 bytes.
export function shortName(name: string): string {
  let short = name.trim();
  while (new TextEncoder().encode(short).length > 100) short = [...short].slice(0, -1).join("");
  return short;
}
