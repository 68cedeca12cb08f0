/// Sends one file as it is, without reading it into memory. XMLHttpRequest because it tells how far it is; fetch does not.

import { ApiError, errorOf, fileUrl, noAnswer } from "./client";

export interface Upload {
  readonly done: Promise<void>;
  stop(): void;
}

export function putFile(job: string, name: string, body: Blob, sent: (bytes: number) => void): Upload {
  const request = new XMLHttpRequest();
  const done = new Promise<void>((resolve, reject) => {
    request.upload.onprogress = (event) => sent(event.loaded);
    request.onload = () => {
      if (request.status >= 200 && request.status < 300) resolve();
      else reject(errorOf(request.status, bodyOf(request.responseText)));
    };
    request.onerror = () => reject(new ApiError(noAnswer, 0));
    request.onabort = () => reject(new DOMException("stopped", "AbortError"));
  });
  request.open("PUT", fileUrl(job, name));
  request.setRequestHeader("Content-Type", "application/octet-stream");
  request.send(body);
  return { done, stop: () => request.abort() };
}

function bodyOf(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch {
    return null;
  }
}
