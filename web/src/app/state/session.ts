/// One open job: its draft with undo, its files, its run. Components watch the stores; all that happens goes through here.

import { api } from "../../api/client";
import type { Info, Job, Parts } from "../../api/types";
import { BuildWork } from "../change/work";
import { attempt } from "./app_state";
import { newBuildView } from "./build_view";
import type { Draft } from "./draft";
import { renameFile } from "./draft_edit";
import { type NamedFile, nameFiles, type PickedFile, type RefusedFile } from "./file_names";
import { History } from "./history";
import { fromJobFile } from "./job_file_read";
import { kept } from "./kept";
import { MeshStore } from "./mesh_store";
import { fingerprint, newDraft } from "./new_draft";
import { PartSource } from "./part_source";
import { newPartsView } from "./parts_view";
import { isRunning, Runner } from "./runner";
import { Saver } from "./saver";
import { type Keeps, startPacking } from "./start_packing";
import { Store } from "./store";
import { known, type Texts, takeIn } from "./take_in";
import { toast } from "./toasts";
import { Uploads } from "./uploads";

export interface SessionState {
  readonly draft: Draft;
  readonly canUndo: boolean;
  readonly canRedo: boolean;
  /// Files that were not sent, and why.
  readonly refused: readonly RefusedFile[];
  /// Bad files that are about to be removed.
  readonly dismissed: ReadonlySet<string>;
}

export class Session {
  readonly state: Store<SessionState>;
  readonly view = newPartsView();
  readonly build = newBuildView();
  readonly meshes: MeshStore;
  readonly saver: Saver;
  readonly uploads: Uploads;
  readonly source: PartSource;
  readonly run: Runner;
  /// What is done to the build by hand.
  readonly work: BuildWork;
  private readonly history: History<Draft>;
  private filesOf: Parts | null = null;
  private fileNames: ReadonlySet<string> = new Set();

  constructor(
    readonly info: Info,
    job: Job,
  ) {
    const draft = newDraft(info);
    this.history = new History(draft);
    this.state = new Store<SessionState>({
      draft,
      canUndo: false,
      canRedo: false,
      refused: [],
      dismissed: new Set(),
    });
    this.run = new Runner(job);
    this.meshes = new MeshStore(job.id);
    this.work = new BuildWork(this);
    this.saver = new Saver(job.id, (file) => this.files.has(file));
    this.uploads = new Uploads(job.id, (name, refused) => this.fileSent(name, refused));
    this.source = new PartSource(
      job.id,
      () => this.uploads.state.value.active,
      (parts, fresh, texts) => this.takeFiles(parts, fresh, texts),
    );
  }

  get id(): string {
    return this.run.id;
  }

  get job(): Job {
    return this.run.state.value.job;
  }

  get draft(): Draft {
    return this.state.value.draft;
  }

  get parts(): Parts {
    return this.source.state.value.parts;
  }

  /// Files that are on the server and hold meshes.
  private get files(): ReadonlySet<string> {
    if (this.filesOf !== this.parts) {
      this.filesOf = this.parts;
      this.fileNames = new Set(this.parts.meshes.map((mesh) => mesh.file));
    }
    return this.fileNames;
  }

  /// While it is packed, nothing of it can be changed.
  get locked(): boolean {
    return isRunning(this.job);
  }

  /// `made`: by this page just now, so that it has no job file yet.
  async open(made: boolean): Promise<void> {
    const [file, parts] = await Promise.all([made ? null : api.jobFile(this.id), this.source.refresh()]);
    const said = Array.isArray(file?.parts) && file.parts.length > 0;
    const draft = file && said ? fromJobFile(file, parts.meshes) : this.draft;
    this.history.reset(draft);
    this.show();
    this.saver.begin(draft, said);
    // A file that comes may be one that the draft names already.
    this.source.state.subscribe(() => this.saver.change(this.draft));
    if (!said) this.source.addAll();
    else if (parts.reading > 0) this.source.soon(0);
    this.run.begin();
  }

  close(): void {
    this.work.close();
    this.uploads.stop();
    this.source.close();
    this.saver.close();
    this.run.close();
  }

  // The draft ------------------------------------------------------------------------------------------------------

  edit(change: (draft: Draft) => Draft, tag = ""): void {
    if (this.locked) return;
    this.history.change(change(this.draft), tag);
    this.show();
    this.saver.change(this.draft);
  }

  /// A change that a toast takes back.
  editWithToast(text: string, change: (draft: Draft) => Draft): void {
    this.edit(change);
    const after = this.draft;
    toast(text, () => {
      if (this.draft === after) this.undo();
    });
  }

  undo(): void {
    this.step(() => this.history.undo());
  }

  redo(): void {
    this.step(() => this.history.redo());
  }

  private step(move: () => void): void {
    if (this.locked) return;
    move();
    this.show();
    this.saver.change(this.draft);
  }

  private show(): void {
    const { value, canUndo, canRedo } = this.history;
    this.state.set({ draft: value, canUndo, canRedo });
    const { current, chosen } = this.view.value;
    const keys = new Set(value.parts.map((part) => part.key));
    const still = new Set([...chosen].filter((key) => keys.has(key)));
    this.view.set({
      current: current !== null && keys.has(current) ? current : (value.parts[0]?.key ?? null),
      chosen: still.size === chosen.size ? chosen : still,
    });
  }

  // Files ----------------------------------------------------------------------------------------------------------

  addFiles(picked: readonly PickedFile[]): void {
    const { files, refused } = nameFiles(picked, this.info.limits.file_bytes);
    const names = new Set(files.map(({ name }) => name));
    const before = this.state.value.refused.filter(({ file }) => !names.has(file));
    this.state.set({ refused: [...before, ...refused] });
    this.uploads.add(files);
  }

  /// Another file under the name of one that cannot be used, or is not there.
  replaceFile(name: string, file: File): void {
    this.dismissRefused(name);
    const own = file.name.split(".").pop()?.toLowerCase();
    const sameKind = own === name.split(".").pop()?.toLowerCase();
    const named: NamedFile = { file, name: sameKind ? name : file.name };
    if (!sameKind) {
      // It is another file then, and parts of the old one are parts of it.
      this.edit((draft) => renameFile(draft, name, named.name));
      if (known(this.parts).has(name)) void this.removeFile(name);
    }
    this.uploads.add([named]);
  }

  /// Of a file that cannot be used: it is removed once the toast is over.
  leaveOutFiles(names: readonly string[]): void {
    const { dismissed, refused } = this.state.value;
    this.state.set({ dismissed: new Set([...dismissed, ...names]) });
    const text = names.length === 1 ? `${names[0]} is left out.` : `${names.length} files are left out.`;
    const back = () => {
      const still = new Set(this.state.value.dismissed);
      for (const name of names) still.delete(name);
      this.state.set({ dismissed: still });
    };
    const onServer = names.filter((name) => !refused.some(({ file }) => file === name));
    toast(text, back, () => {
      for (const name of names) this.dismissRefused(name);
      void Promise.all(onServer.map((name) => this.removeFile(name))).then(back);
    });
  }

  private async removeFile(name: string): Promise<void> {
    await attempt(() => api.deleteFile(this.id, name));
    await attempt(() => this.source.refresh());
  }

  private dismissRefused(name: string): void {
    this.state.set({ refused: this.state.value.refused.filter(({ file }) => file !== name) });
  }

  private fileSent(name: string, refused: RefusedFile | null): void {
    if (refused) this.state.set({ refused: [...this.state.value.refused, refused] });
    else this.source.add(name);
  }

  private takeFiles(parts: Parts, fresh: ReadonlySet<string>, texts: Texts): void {
    const first = this.draft.parts.length === 0 && !this.history.canUndo;
    this.edit((draft) => takeIn(draft, parts, fresh, texts), "take in");
    // What a new job begins with is no change of it.
    if (!first || this.locked) return;
    this.history.reset(this.draft);
    this.show();
  }

  // Packing --------------------------------------------------------------------------------------------------------

  /// Packs what the draft says, and shows it.
  pack(keeps: Keeps = "none"): Promise<void> {
    return startPacking(this, keeps);
  }

  /// With another draft, as a remedy has it.
  async packWith(draft: Draft): Promise<void> {
    this.edit(() => draft);
    await this.pack();
  }

  /// Goes on with a run that was interrupted.
  async goOn(): Promise<void> {
    await attempt(() => this.run.start("pack", () => api.start(this.id)));
  }

  async stop(): Promise<void> {
    await attempt(() => this.run.cancel());
  }

  /// Parts or settings are not those that the build was packed with, as far as this browser knows.
  get changedSince(): boolean {
    const packed = kept<string | null>(`packed.${this.id}`, null);
    return packed !== null && packed !== fingerprint(this.draft);
  }
}
