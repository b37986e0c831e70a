// Parts of the page that come when they are first asked for.

/** What has been asked for, or that there is no network to bring it. */
export const fetched = <Part>(part: Promise<Part>) =>
  part.catch(() => {
    throw new Error("page.not_loaded");
  });
